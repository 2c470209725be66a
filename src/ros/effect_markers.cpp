#include "poinsot/ros/effect_markers.h"

#include <algorithm>
#include <string>
#include <variant>

#include "poinsot/ros/conversions.h"
#include "poinsot/ros/palette.h"

namespace poinsot::node {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

// Lengths in metres.
constexpr double kTorqueBeyond = 0.4;      // of the largest torque's arrow, beyond the body
constexpr double kTorqueAtMomentum = 0.7;  // of the largest torque's arrow at the tip of L
constexpr double kHiddenShare = 0.5;       // of the body, in which an arrow that is no longer ends unseen
constexpr double kLeastArrow = 0.01;       // what would be shorter is not drawn
constexpr double kMostBeyond = 1.2;        // times the length of the largest torque that was expected
constexpr double kWeightBeyond = 0.3;
constexpr double kOrbitBeyond = 0.3;
constexpr double kPivotDiameter = 0.13;
constexpr double kRodDiameter = 0.05;
constexpr double kBeside = 0.16;  // of a symbol, from the tip of its arrow
constexpr double kWayLength = 9;
constexpr double kWaySpacing = 0.02;
constexpr double kWayWidth = 0.022;

// Ids within <body>/torque and <body>/gravity.
enum TorqueId { kAtBody, kAtMomentum };
enum GravityId { kPivot, kRod, kWeight, kToCentre, kWay };

bool exertsTorque(const Effect& effect) {
  return !std::holds_alternative<InternalDissipation>(effect);
}

/** Beyond the tip of an arrow, and to its side for a viewer at +x where it points at him. */
Eigen::Vector3d beyond(const Eigen::Vector3d& tip, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d seen(0, direction.y(), direction.z());
  const Eigen::Vector3d to_side = seen.norm() > 0.3 ? seen.normalized() : Eigen::Vector3d(0, -0.7, 0.7);
  return tip + kBeside * to_side;
}

}  // namespace

EffectMarkers::EffectMarkers(const MarkerFactory& factory, const Motion& motion, const Sizes& sizes)
    : factory_(factory),
      sizes_(sizes),
      way_(static_cast<std::size_t>(kWayLength / kWaySpacing), kWayLength, kWaySpacing) {
  for (const Effect& effect : motion.setup().effects) {
    torque_ = torque_ || exertsTorque(effect);
    if (const auto* weight = std::get_if<GravityTorque>(&effect)) weight_ = *weight;
  }
  if (motion.torques()) orbit_ = motion.torques()->gradient();
}

double EffectMarkers::depth() const {
  if (orbit_) return sizes_.reach + kOrbitBeyond + 3 * kBeside;  // a word
  if (!weight_) return torque_ ? sizes_.reach + kTorqueBeyond + 2 * kBeside : 0;
  return weight_->centre_of_mass.norm() + sizes_.shape_radius + kWeightBeyond + 2 * kBeside;
}

void EffectMarkers::appendStatic(MarkerArray& out) const {
  if (!weight_) return;
  Marker pivot = factory_.marker(factory_.ns(names::kGravity), kPivot, Marker::SPHERE, factory_.frames().body);
  pivot.scale = toVector3(Eigen::Vector3d::Constant(kPivotDiameter));
  pivot.color = palette::pivot();
  pivot.frame_locked = true;
  out.markers.push_back(pivot);

  const Eigen::Vector3d& centre = weight_->centre_of_mass;
  if (centre.isZero(0)) return;
  Marker rod = factory_.marker(factory_.ns(names::kGravity), kRod, Marker::CYLINDER, factory_.frames().body);
  rod.pose.position = toPoint(0.5 * centre);
  rod.pose.orientation = toQuaternion(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), centre));
  rod.scale = toVector3({kRodDiameter, kRodDiameter, centre.norm()});
  rod.color = palette::pivot();
  rod.frame_locked = true;
  out.markers.push_back(rod);
}

void EffectMarkers::appendMoving(const MotionState& state, const Eigen::Vector3d& torque_world, MarkerTracker& tracker,
                                 MarkerArray& out) {
  if (torque_) appendTorque(state, torque_world, tracker, out);
  if (weight_ && !weight_->centre_of_mass.isZero(0)) appendWay(state, tracker, out);
  const auto draw = [&](int id, LabelId symbol_id, const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
                        double length, const char* symbol) {
    const Eigen::Vector3d tip = from + length * direction;
    Marker arrow = factory_.arrow(factory_.ns(names::kGravity), id, names::kWorld, from, tip);
    Marker label = factory_.text(symbol_id, names::kWorld, beyond(tip, direction), symbol, kSymbolHeight);
    arrow.color = label.color = palette::gravity();
    tracker.put(arrow, out);
    tracker.put(label, out);
  };
  if (weight_ && !weight_->gravity.isZero(0)) {
    draw(kWeight, kWeightSymbol, state.position + state.attitude * weight_->centre_of_mass,
         weight_->gravity.stableNormalized(), sizes_.shape_radius + kWeightBeyond, "mg");
  }
  if (orbit_) {
    draw(kToCentre, kOrbitSymbol, state.position, -orbit_->radialAt(state.time), sizes_.reach + kOrbitBeyond, "centre");
  }
}

void EffectMarkers::appendWay(const MotionState& state, MarkerTracker& tracker, MarkerArray& out) {
  const Eigen::Vector3d& centre = weight_->centre_of_mass;
  way_.add(state.position + state.attitude * (centre + sizes_.shape_radius * centre.stableNormalized()));
  const std::string ns = factory_.ns(names::kGravity);
  if (way_.size() < 2) return tracker.removeOne(ns, kWay, out);
  Marker way = factory_.marker(ns, kWay, Marker::LINE_STRIP, names::kWorld);
  way.points.reserve(way_.size());
  for (std::size_t i = 0; i < way_.size(); ++i) way.points.push_back(toPoint(way_[i]));
  way.scale.x = kWayWidth;
  way.color = palette::path();
  tracker.put(way, out);
}

void EffectMarkers::appendTorque(const MotionState& state, const Eigen::Vector3d& torque_world, MarkerTracker& tracker,
                                 MarkerArray& out) const {
  const std::string ns = factory_.ns(names::kTorque);
  const auto draw = [&](int id, LabelId symbol_id, const std::string& frame, const Eigen::Vector3d& from,
                        double longest, double hidden) {
    Eigen::Vector3d way = sizes_.torque > 0 ? Eigen::Vector3d(longest * (torque_world / sizes_.torque))
                                            : Eigen::Vector3d(Eigen::Vector3d::Zero());
    // A torque beyond what was expected would leave the picture.
    if (way.norm() > kMostBeyond * longest) way *= kMostBeyond * longest / way.norm();
    if (!(way.norm() > kLeastArrow) || !way.allFinite()) {
      tracker.removeOne(ns, id, out);
      tracker.removeOne(factory_.ns(symbol_id), symbol_id, out);
      return;
    }
    Marker arrow = factory_.arrow(ns, id, frame, from, from + way);
    arrow.color = palette::torque();
    tracker.put(arrow, out);
    if (way.norm() < hidden) {  // a name alone would puzzle
      tracker.removeOne(factory_.ns(symbol_id), symbol_id, out);
      return;
    }
    Marker label = factory_.text(symbol_id, frame, beyond(from + way, way.normalized()), "\xCF\x84", kSymbolHeight);
    label.color = palette::torque();
    tracker.put(label, out);
  };
  draw(kAtBody, kTorqueSymbol, names::kWorld, state.position, sizes_.reach + kTorqueBeyond,
       kHiddenShare * sizes_.reach);
  draw(kAtMomentum, kTorqueAtMomentumSymbol, factory_.frames().space,
       sizes_.metres_per_angular_momentum * state.momentum_world, kTorqueAtMomentum, 0);
}

}  // namespace poinsot::node
