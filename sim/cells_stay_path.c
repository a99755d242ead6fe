// SPDX-License-Identifier: MIT
#include "cells.h"
#include <brink/path.h>

#ifdef BRINK_DISPATCH
BRINK_CHOOSE_BATCH(brink_cells_stay,
                   (const brink_cells *c, const brink_system *system, uint32_t i,
                    double offset, brink_stay *stay),
                   (c, system, i, offset, stay))
#endif
