// What the layout of the scene needs to know of a body.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "markers/parts.h"

namespace poinsot::node::parts {
namespace {

constexpr double kWatched = 20;  // s: so long a body that flies, or swings on a pivot, is to be in view
constexpr int kSamples = 40;
constexpr double kFarthest = 4;  // times its reach: what flies further is followed
constexpr double kArrows = 1.3;  // of a body with its torque's arrow, times its reach
constexpr double kOrbitArrow = 1.5;
constexpr double kFineness = 0.6;     // of the pictures of a body on a pivot, which has the frame for itself
constexpr double kPivotReach = 0.32;  // of the pivot, likewise
constexpr double kMostSteps = 1e4;
constexpr double kFarthestDrawn = 1e9;  // m: no viewer shows anything so far away
constexpr std::size_t kMany = 3;        // bodies: with so many, one picture each is enough
constexpr int kLinesOfFree = 5, kLinesUnderTorque = 3;

void appendFlown(const Subject& subject, double radius, const std::optional<double>& loop,
                 std::vector<view::Ball>& out) {
  const double horizon = loop.value_or(kWatched);
  for (int i = 1; i <= kSamples; ++i) {
    const Eigen::Vector3d place = subject.translation->positionAt(horizon * i / kSamples);
    const double flown = (place - subject.start.position).stableNorm();
    if (!std::isfinite(flown) || (!loop && flown > kFarthest * radius)) return;
    out.push_back({place, radius});
  }
}

/** What is shown where the scene does not say it. */
scene::Pictures picturesThatSuit(const Subject& subject, std::size_t bodies) {
  if (subject.wanted != scene::Pictures::as_it_suits) return subject.wanted;
  if (subject.weight || subject.orbit) return scene::Pictures::apart;
  return bodies < kMany ? scene::Pictures::both : scene::Pictures::body;
}

}  // namespace

std::vector<view::Ball> sweptOnPivot(const Subject& subject, Motion motion) {
  Eigen::AlignedBox3d box;
  double horizon = kWatched;
  if (const auto& step = motion.setup().step) horizon = std::min(horizon, kMostSteps * *step);
  try {
    for (int i = 0; i <= kSamples; ++i) {
      const MotionState state = motion.at(horizon * i / kSamples);
      box.extend(subject.farEnd(state));
      for (const Solid& solid : subject.shape.parts()) {
        const Eigen::AlignedBox3d corners(-0.5 * solid.size, 0.5 * solid.size);
        for (int k = 0; k < 8; ++k) {
          const Eigen::Vector3d corner = corners.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k));
          const Eigen::Vector3d in_body = subject.shape_position + solid.centre + solid.orientation * corner;
          box.extend(Eigen::Vector3d(state.position + state.attitude * in_body));
        }
      }
    }
  } catch (const std::runtime_error&) {  // the motion ends here
  }
  std::vector<view::Ball> out;
  for (int k = 0; k < 8 && !box.isEmpty(); ++k) {
    out.push_back({box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k)), 0});
  }
  return out;
}

view::BodyExtent extentOf(const Subject& subject, const SceneFacts& scene) {
  view::BodyExtent out;
  out.radius = std::min((subject.weight ? kFineness : 1) * subject.reach, kFarthestDrawn);
  if (subject.weight) {
    out.body = {{subject.start.position, kPivotReach * subject.reach}};
    const std::vector<view::Ball>& swept = subject.swept;
    out.body.insert(out.body.end(), swept.begin(), swept.end());
  } else {
    const double arrows = subject.orbit ? kOrbitArrow : subject.is_pushed ? kArrows : 1;
    out.body = {{subject.start.position, arrows * subject.reach}};
  }
  if (subject.flies()) appendFlown(subject, subject.reach, scene.loop, out.body);
  for (view::Ball& ball : out.body) {
    ball.centre = ball.centre.cwiseMax(-kFarthestDrawn).cwiseMin(kFarthestDrawn);
    ball.radius = std::min(ball.radius, kFarthestDrawn);
  }
  const scene::Pictures pictures = picturesThatSuit(subject, scene.bodies);
  const bool has_pictures = subject.hasPictures();
  out.has_words = pictures != scene::Pictures::none;
  out.shows_world = has_pictures && (pictures == scene::Pictures::both || pictures == scene::Pictures::world);
  out.shows_body = has_pictures && (pictures == scene::Pictures::both || pictures == scene::Pictures::body);
  out.shows_orbit = subject.orbit.has_value() && pictures != scene::Pictures::none;
  if (subject.keeps_momentum) out.momentum = subject.start.momentum_world.stableNormalized();
  out.picture_depth = beadSymbolDepth(subject);
  out.letters = static_cast<int>(scene::lettersOf(subject.name));
  out.lines = scene.some_body_steps ? (subject.closed_form ? kLinesOfFree : kLinesUnderTorque) : 1;
  return out;
}

}  // namespace poinsot::node::parts
