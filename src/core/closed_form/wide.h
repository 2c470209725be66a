#pragma once

#include "levels.h"

// The same closed form in numbers of over two thousand bits and any exponent, for cases out of double-double's reach.
namespace poinsot::closed_form {

/** Returns whether double-double can set this start up, because no relevant quantity underflows. So for almost all. */
bool isOrdinary(const Start& start);

/** Sets up any start, in milliseconds. */
void setUpWide(const Start& start, Constants& constants);

/** Like those of Level, for any finite times; each takes milliseconds. */
void phasesWide(const Start& start, const Constants& constants, double t, Phases& out);
void sampleWide(const Start& start, const Constants& constants, double t0, double dt, long n, double* const columns[7]);

}  // namespace poinsot::closed_form
