#include "speed_scale.h"

#include <algorithm>
#include <cmath>

namespace poinsot::rviz_panel::speed_scale {
namespace {

constexpr double kPositionsPerDecade = kPositions / 4.0;
constexpr int kMiddle = kPositions / 2;

}  // namespace

double speedAt(int position) {
  return std::pow(10, (std::clamp(position, 0, kPositions) - kMiddle) / kPositionsPerDecade);
}

int positionOf(double speed) {
  const double magnitude = std::abs(speed);
  if (!(magnitude > kSlowest)) return 0;
  if (magnitude >= kFastest) return kPositions;
  return kMiddle + static_cast<int>(std::lround(kPositionsPerDecade * std::log10(magnitude)));
}

}  // namespace poinsot::rviz_panel::speed_scale
