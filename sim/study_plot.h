// SPDX-License-Identifier: MIT
#ifndef BRINK_STUDY_PLOT_H
#define BRINK_STUDY_PLOT_H
/**
 * The study's plot: relative energy error against events, of every method, each
 * curve labelled at its end; a cross where a method was stopped.  Samples whose
 * error is exactly 0, which a logarithmic axis has no place for, stand in a band
 * below it.
 */
#include "study_findings.h"

/** The script for brink_report_figure, to be freed; NULL if memory is out.  The
 * samples are in the files that brink_findings_file names. */
char *brink_energy_plot(const brink_case *c);
#endif
