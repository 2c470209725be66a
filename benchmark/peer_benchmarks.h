#pragma once

namespace poinsot::benchmarks {

/**
 * Registers peer/odeint_rk4_step, what one would write with a general solver, to which the other figures are ratios;
 * and peer/odeint_rk4_step/function, the same with the equations of motion behind a function pointer.
 */
void addPeers();

}  // namespace poinsot::benchmarks
