#pragma once

namespace poinsot::benchmarks {

/**
 * peer/odeint_rk4_step: what one would write with a general solver, the yardstick of the other figures; then
 * peer/odeint_rk4_step/function, the same with the equations of motion behind a function pointer.
 */
void addPeers();

}  // namespace poinsot::benchmarks
