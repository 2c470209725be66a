#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include "markers/layout.h"
#include "markers/parts.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/ros/markers/palette.h"
#include "poinsot/view/picture_bounds.h"
#include "poinsot/view/trail.h"

namespace poinsot::node::parts {
namespace {

constexpr double kHiddenShare = 0.4;     // of the longest arrow: shorter ones end unseen inside the body
constexpr double kBesidePivot = 0.7;     // of the body's reach
constexpr double kMostBeyond = 1.2;      // times the length of the largest torque that was expected
constexpr double kPivotDiameter = 0.13;  // times the reach of the body
constexpr double kRodDiameter = 0.05;
constexpr double kWayLength = 9;  // times the reach of the body
constexpr double kWaySpacing = 0.02;
constexpr double kWayWidth = 0.022;

// Of the picture of an orbit, in radii of a picture.
constexpr double kPlanetRadius = 0.42, kOrbitRadius = 1.05, kOnOrbitReach = 0.42;
constexpr int kOrbitPieces = 72;

// Ids within <body>/orbit, <body>/torque and <body>/gravity.
enum OrbitId { kPlanet, kOrbitLine, kOnOrbit };
enum TorqueId { kAtBody, kAtMomentum };
enum GravityId { kPivot, kRod, kWeight, kToCentre, kWay };

/** Returns a place so far beyond the tip of an arrow; beside the tip where the arrow points at a viewer at +x. */
Eigen::Vector3d beyond(const Eigen::Vector3d& tip, const Eigen::Vector3d& direction, double distance) {
  const Eigen::Vector3d seen(0, direction.y(), direction.z());
  const Eigen::Vector3d to_side = seen.norm() > 0.3 ? seen.normalized() : Eigen::Vector3d(0, -0.7, 0.7);
  return tip + distance * to_side;
}

/** Puts an arrow in <body>/gravity, and its name from its tip in that direction. */
void putGravity(const Subject& subject, GravityId id, LabelId symbol_id, const Eigen::Vector3d& from,
                const Eigen::Vector3d& direction, double length, const char* symbol,
                const Eigen::Vector3d& symbol_towards, Canvas& canvas) {
  const MarkerFactory& factory = subject.factory;
  const Eigen::Vector3d tip = from + length * direction;
  canvas.put(factory.arrow(factory.ns(names::kGravity), id, names::kWorld, from, tip, palette::kGravity));
  canvas.put(factory.text(symbol_id, names::kWorld,
                          beyond(tip, symbol_towards, layout::kBesideEffect * subject.frame.text * subject.unit()),
                          symbol, layout::kSymbolHeight, palette::kGravity));
}

class Way : public Part {
 public:
  explicit Way(double reach)
      : way_(static_cast<std::size_t>(kWayLength / kWaySpacing), kWayLength * reach, kWaySpacing * reach) {}

  void appendMoving(const Subject& subject, const Now& now, Canvas& canvas) override {
    way_.add(subject.farEnd(now.state));
    Marker way = subject.factory.marker(subject.factory.ns(names::kGravity), kWay, Marker::LINE_STRIP, names::kWorld,
                                        {kWayWidth, 0, 0}, palette::kPath);
    for (std::size_t i = 0; i < way_.size(); ++i) way.points.push_back(toPoint(way_[i]));
    canvas.show(way_.size() > 1, way);
  }

  void clearTrail() override { way_.clear(); }

 private:
  view::Trail way_;  ///< world axes
};

class OnOrbit : public Part {
 public:
  explicit OnOrbit(const Subject& subject) : shape_(shapeOf(subject)) {}

  void appendMoving(const Subject& subject, const Now& now, Canvas& canvas) override {
    const Eigen::Vector3d radial = now.motion.torques()->gradient()->radialAt(now.state.time);
    const Eigen::Vector3d place = subject.frame.place.orbit_centre + kOrbitRadius * subject.unit() * radial;
    int id = kOnOrbit;
    for (Marker& marker : copyOf(shape_, place, now.state.attitude, kOnOrbitReach * subject.unit() / subject.reach)) {
      marker.ns = subject.factory.ns(names::kOrbit);
      marker.id = id++;
      canvas.put(marker);
    }
  }

 private:
  const std::vector<Marker> shape_;
};

}  // namespace

bool isPushed(const Motion& motion) {
  const std::vector<Effect>& effects = motion.setup().effects;
  return std::any_of(effects.begin(), effects.end(),
                     [](const Effect& effect) { return !std::holds_alternative<InternalDissipation>(effect); });
}

void appendTorque(const Subject& subject, const Now& now, Canvas& canvas) {
  const MarkerFactory& factory = subject.factory;
  const std::string ns = factory.ns(names::kTorque);
  const double expected = subject.frame.bounds.torque;
  const Eigen::Vector3d torque_world = view::externalTorque(now.motion, now.state);
  const auto draw = [&](TorqueId id, LabelId symbol_id, const std::string& frame, const Eigen::Vector3d& from,
                        double longest, double hidden, double unit) {
    Eigen::Vector3d way = Eigen::Vector3d::Zero();
    if (expected > 0) way = longest * (torque_world / expected);
    // A torque beyond what was expected would leave the picture.
    if (way.norm() > kMostBeyond * longest) way *= kMostBeyond * longest / way.norm();
    const bool drawn = way.norm() > layout::kLeastTorque * unit && way.allFinite();
    canvas.show(drawn, factory.arrow(ns, id, frame, from, from + way, palette::kTorque));
    // No name where the arrow ends inside the body.
    const Eigen::Vector3d symbol =
        beyond(from + way, way.normalized(), layout::kBesideEffect * subject.frame.text * unit);
    canvas.show(drawn && way.norm() >= hidden,
                factory.text(symbol_id, frame, symbol, "\xCF\x84", layout::kSymbolHeight, palette::kTorque));
  };
  // Of a body on a pivot, the arrow is beside the body in any case.
  const double longest =
      subject.weight ? kBesidePivot * subject.reach : subject.reach + layout::kTorqueBeyond * subject.unit();
  draw(kAtBody, kTorqueSymbol, names::kWorld, now.state.position, longest, kHiddenShare * longest, subject.unit());
  draw(kAtMomentum, kTorqueAtMomentumSymbol, factory.frames().space,
       subject.frame.scale.metres_per_angular_momentum * now.state.momentum_world, layout::kTorqueAtMomentum, 0, 1);
}

void appendPivot(const Subject& subject, Canvas& canvas) {
  const MarkerFactory& factory = subject.factory;
  const std::string ns = factory.ns(names::kGravity);
  canvas.put(locked(factory.marker(ns, kPivot, Marker::SPHERE, factory.frames().body,
                                   Eigen::Vector3d::Constant(kPivotDiameter * subject.reach), palette::kPivot)));
  const Eigen::Vector3d& centre = subject.weight->centre_of_mass;
  if (centre.isZero(0)) return;
  Marker rod = locked(factory.marker(ns, kRod, Marker::CYLINDER, factory.frames().body,
                                     {kRodDiameter * subject.reach, kRodDiameter * subject.reach, centre.norm()},
                                     palette::kPivot));
  rod.pose.position = toPoint(0.5 * centre);
  rod.pose.orientation = toQuaternion(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), centre));
  canvas.put(rod);
}

void appendWeight(const Subject& subject, const Now& now, Canvas& canvas) {
  const GravityTorque& weight = *subject.weight;
  if (weight.gravity.isZero(0)) return;
  putGravity(subject, kWeight, kWeightSymbol, now.state.position + now.state.attitude * weight.centre_of_mass,
             weight.gravity.stableNormalized(), subject.shape_radius + layout::kWeightBeyond * subject.unit(), "mg",
             Eigen::Vector3d(0, 1.4, -0.4), canvas);
}

void appendWayToCentre(const Subject& subject, const Now& now, Canvas& canvas) {
  const Eigen::Vector3d to_centre = -now.motion.torques()->gradient()->radialAt(now.state.time);
  putGravity(subject, kToCentre, kOrbitSymbol, now.state.position, to_centre,
             subject.reach + layout::kOrbitBeyond * subject.unit(), "centre", to_centre, canvas);
}

void appendPlanet(const Subject& subject, Canvas& canvas) {
  const MarkerFactory& factory = subject.factory;
  const std::string ns = factory.ns(names::kOrbit);
  const double unit = subject.unit();
  const Eigen::Vector3d& centre = subject.frame.place.orbit_centre;
  Marker planet = factory.marker(ns, kPlanet, Marker::SPHERE, names::kWorld,
                                 Eigen::Vector3d::Constant(2 * kPlanetRadius * unit), palette::kPlanet);
  planet.pose.position = toPoint(centre);
  canvas.put(planet);
  Marker orbit =
      factory.marker(ns, kOrbitLine, Marker::LINE_STRIP, names::kWorld, {layout::kPathWidth, 0, 0}, palette::kFlight);
  for (int i = 0; i <= kOrbitPieces; ++i) {
    const Eigen::Vector3d radial = subject.orbit->radialAt(2 * M_PI * i / (kOrbitPieces * subject.orbit->rate));
    orbit.points.push_back(toPoint(centre + kOrbitRadius * unit * radial));
  }
  canvas.put(orbit);
  canvas.put(factory.text(kOrbitTitle, names::kWorld,
                          subject.belowTitle(centre, subject.frame.place.picture_title_depth, 0), "on its orbit",
                          layout::kTitleHeight));
}

std::unique_ptr<Part> makeOnOrbit(const Subject& subject) {
  return std::make_unique<OnOrbit>(subject);
}

std::unique_ptr<Part> makeWay(const Subject& subject) {
  return std::make_unique<Way>(subject.reach);
}

}  // namespace poinsot::node::parts
