#pragma once

namespace poinsot::benchmarks {

/**
 * closed_form/setup and closed_form/at, a call each, and closed_form/sample_per_state, a state of a grid of 6000, for a
 * body far from the separatrix; then the same of every regime: …/<regime>, sample_per_state/<regime>/<states>.
 */
void addClosedForm();

}  // namespace poinsot::benchmarks
