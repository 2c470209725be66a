#pragma once

#include "levels.h"

// The same closed form in numbers of over two thousand bits and any exponent: what leaves the reach of double-double.
namespace poinsot::closed_form {

/** Whether double-double can set this start up: no quantity underflows that matters. Almost all starts. */
bool isOrdinary(const Start& start);

/** For any start. Takes milliseconds. */
void setUpWide(const Start& start, Constants& constants);

/** As in Level, for any finite times. Take milliseconds. */
void phasesWide(const Start& start, const Constants& constants, double t, Phases& out);
void sampleWide(const Start& start, const Constants& constants, double t0, double dt, long n, double* const columns[7]);

}  // namespace poinsot::closed_form
