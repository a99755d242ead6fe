// SPDX-License-Identifier: MIT
#ifndef BRINK_REPORT_GNUPLOT_H
#define BRINK_REPORT_GNUPLOT_H
/**
 * A plot, drawn by the program gnuplot, as SVG that can stand in a page.
 */
#include <stddef.h>

/**
 * Runs gnuplot on a script, in `folder`, so that the script names data files
 * there without a path.  Terminal, fonts, colours (linetypes 1 to 8, told apart
 * by the colour-blind) and grid are set before it.  Script and drawing stay in
 * the folder as NAME.gnuplot and NAME.svg.
 *
 * Returns   the element <svg>...</svg>, to be freed, every id in it made
 * different from those of other drawings by `number`; or NULL, with why in
 * *trouble.
 */
char *brink_gnuplot_draw(const char *folder, const char *name, const char *script,
                         int number, char *trouble, size_t size);
#endif
