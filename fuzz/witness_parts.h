// SPDX-License-Identifier: MIT
#ifndef FUZZ_WITNESS_PARTS_H
#define FUZZ_WITNESS_PARTS_H
/** What a witness looks at, part by part; what of it is kept, witness.c knows. */
#include "witness.h"

/** The log's level of a pair. */
int *witness_level(const witness *w, uint32_t i, uint32_t j);

/**
 * How far a pair may be from where its level says.  In units of 2^-53:
 *
 * A prediction looks at a pair whose nearest image is at most sqrt(3)/2 L away, L
 * the longest side, and each flies at most sqrt(3) L until it is looked at anew:
 * a particle crosses a cell, at most L/3 wide, or departs from home, and who
 * meets it has come no further than to it.  Its time is within 16 (8 ulp), which
 * the pair flies L in; or, by the fast tier, the pair within 16 (L + sigma).  The
 * separation that it is predicted from has some 6 roundings of lengths below 3 L
 * on each of three axes; the same again when the event is executed.  A position
 * is rounded whenever it is written down, by 3 of the flight since, and by half a
 * unit of 2^-64 L.  Flights add up to those above; times of writing down are
 * events of the run, which are few enough to forget their units.  In all some
 * 16 sqrt(3) + 2 * 6 * 3 + 3 * 2 sqrt(3) < 75 L.
 *
 * The instant is rounded to 1 of a year and what follows, offsets are subtracted,
 * twice a particle: 4 years' flight.
 */
double witness_contact_bound(const witness *w);

/** Between the event before and this one no pair, in no image, crosses a step. */
void witness_look_at_flights(const witness *w);

/** The event is legal, at its step, counted, and turns who is turned back. */
void witness_look_at_event(witness *w);
#endif
