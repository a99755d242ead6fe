// SPDX-License-Identifier: MIT
#ifndef BRINK_STUDY_QUESTION_H
#define BRINK_STUDY_QUESTION_H
/**
 * What the study's page begins with: the question, for somebody who has never
 * heard of it, and the six ways to answer it.
 */
#include "report.h"

void brink_question_pose(brink_report *r);
#endif
