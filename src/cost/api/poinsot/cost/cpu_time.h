#pragma once

namespace poinsot::cost {

/** Returns the CPU time of the calling thread [s]. */
double threadCpuTime();

/** Returns the CPU time [s] between two calls of threadCpuTime() with nothing in between; measured once. */
double clockCost();

}  // namespace poinsot::cost
