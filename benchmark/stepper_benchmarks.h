#pragma once

namespace poinsot::benchmarks {

/** Registers step/<method>, one step, for every method of the table, and step/<method>/near_separatrix. */
void addSteppers();

}  // namespace poinsot::benchmarks
