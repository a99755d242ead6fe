// SPDX-License-Identifier: MIT
#include "run_predict.h"
#include <brink/path.h>

#ifdef BRINK_DISPATCH
BRINK_CHOOSE_BATCH(brink_predict, (brink_run * run, uint32_t i, double offset),
                   (run, i, offset))
#endif
