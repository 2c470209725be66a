#pragma once

namespace poinsot::benchmarks {

/** step/<method>, one step of it, for every method of the table; then step/<method>/near_separatrix. */
void addSteppers();

}  // namespace poinsot::benchmarks
