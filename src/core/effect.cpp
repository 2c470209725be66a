#include "poinsot/core/effect.h"

#include "poinsot/core/number_text.h"

namespace poinsot {

std::string effects::text(double value) {
  return numberText(value, 17);
}

std::string effects::text(const Eigen::Vector3d& v) {
  return "[" + text(v.x()) + ", " + text(v.y()) + ", " + text(v.z()) + "]";
}

std::string nameOf(const Effect& effect) {
  return std::visit([](const auto& e) { return std::string(e.kName); }, effect);
}

std::string textOf(const Effect& effect) {
  return std::visit([](const auto& e) { return std::string(e.kName) + ": " + e.text(); }, effect);
}

Torques sumOf(const PrincipalInertia& inertia, const std::vector<Effect>& effects) {
  Torques torques(inertia);
  for (const Effect& effect : effects) std::visit([&torques](const auto& e) { e.addTo(torques); }, effect);
  torques.requireFinite();
  return torques;
}

}  // namespace poinsot
