#include "poinsot/core/effects/translation.h"

namespace poinsot {

Eigen::Vector3d Translation::positionAt(double t) const {
  return position + t * (velocity + (0.5 * t) * acceleration);
}

Eigen::Vector3d Translation::velocityAt(double t) const {
  return velocity + t * acceleration;
}

}  // namespace poinsot
