#pragma once

namespace poinsot::cost {

/** CPU time of the calling thread [s]. */
double threadCpuTime();

/** CPU time [s] that passes between two calls of threadCpuTime() with nothing in between; measured once. */
double clockCost();

}  // namespace poinsot::cost
