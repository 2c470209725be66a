#include <cmath>
#include <iostream>

#include "spin.h"

int main() {
  const poinsot::BodyState state = spinOfTop(2);
  std::cout << "after 2 s: w " << state.attitude.w << ", z " << state.attitude.z << ", E " << state.kinetic_energy
            << "\n";
  const bool right = std::abs(state.attitude.w - std::cos(0.5)) < 1e-9 &&
                     std::abs(state.attitude.z - std::sin(0.5)) < 1e-9 && std::abs(state.kinetic_energy - 0.25) < 1e-12;
  return right ? 0 : 1;
}
