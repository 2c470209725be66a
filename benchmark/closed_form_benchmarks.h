#pragma once

namespace poinsot::benchmarks {

/**
 * Registers closed_form/setup and closed_form/at, one call each, and closed_form/sample_per_state, one state of a grid
 * of 6000, for a body far from the separatrix; then the same for every regime: …/<regime>,
 * sample_per_state/<regime>/<states>.
 */
void addClosedForm();

}  // namespace poinsot::benchmarks
