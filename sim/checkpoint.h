// SPDX-License-Identifier: MIT
#ifndef BRINK_CHECKPOINT_H
#define BRINK_CHECKPOINT_H
/**
 * Runs on disk: DIR/checkpoint-EVENTS.brink.  A file is written beside its place,
 * synced and renamed into it, so that whatever happens there is a whole one; the
 * one before it is kept.
 */
#include "snapshot.h"

/** Writes `run` and `plan` into DIR and removes the checkpoints older than the
 *  one before it; newer ones, which were passed over when this run was resumed,
 *  stay.  0; -1 with a message to `errors`, the earlier checkpoints untouched. */
int brink_checkpoint_save(const char *dir, const brink_run *run,
                          const brink_plan *plan, FILE *errors);

/** What to do about a folder that cannot be written to for this reason (an
 * errno), in the words that go before "and resume". */
const char *brink_checkpoint_remedy(int error);

/** Reads one file.  0; -1 with its name and what is wrong with it to `errors`,
 * and *run and *plan empty; memory as with brink_snapshot_read. */
int brink_checkpoint_load(const char *path, brink_run *run, brink_plan *plan,
                          FILE *errors);

/** Loads the newest whole checkpoint of DIR; damaged ones, and those that bear
 * another's number, are named and passed over. Its path is written to `path`.  0;
 * -1 if there is none. */
int brink_checkpoint_resume(const char *dir, brink_run *run, brink_plan *plan,
                            char *path, size_t path_size, FILE *errors);

/** The newest whole one from before an event, which has fewer executed than
 * `event`.  0; -1 if there is none, said by nobody. */
int brink_checkpoint_before(const char *dir, uint64_t event, brink_run *run,
                            brink_plan *plan, char *path, size_t path_size,
                            FILE *errors);

/** Removes DIR's checkpoints, and DIR if nothing else is in it. */
void brink_checkpoint_clear(const char *dir);

/** Number of checkpoints in DIR, 0 if it does not exist. */
int brink_checkpoint_count(const char *dir);
#endif
