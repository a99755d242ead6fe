// SPDX-License-Identifier: MIT
#ifndef BRINK_STUDY_FINDINGS_H
#define BRINK_STUDY_FINDINGS_H
/**
 * What the study found, put into words, tables and figures.  Every sentence
 * follows from the figures, so that none can be false.
 */
#include "report.h"
#include "scene.h"
#include "study_nudges.h"
#include "study_trial.h"
#include "study_words.h"

typedef struct brink_case { // a scene of the study, and what became of it
    const char *path;
    char name[64]; // for files: letters, digits, '-'
    brink_scene scene;
    uint64_t events; // asked for
    brink_trial trial[BRINK_METHODS];
    uint64_t nudge_events; // for which other nudges were tried
    double nudge_off[BRINK_METHODS]
                    [BRINK_NUDGES]; // see brink_nudge_try; of those that
                                    // do not nudge: nothing
} brink_case;

/** One scene: figure, outcomes, inconsistencies, events. */
void brink_findings_tell(brink_report *r, const brink_case *c);

/** The two sentences that say what one sees in it, to be freed; NULL: no
 *  memory. */
char *brink_findings_sentences(const brink_case *c);

/** What became of a trial, as a verb phrase: "stood still after 1 006 events". */
brink_words brink_findings_outcome(const brink_trial *t);

/** A file of a trial, beside the page: ".dat" its samples. */
void brink_findings_file(const brink_case *c, enum brink_method method,
                         const char *ending, char *name, size_t size);
#endif
