#include <algorithm>
#include <cmath>

#include "markers/layout.h"
#include "markers/parts.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/ros/markers/palette.h"
#include "poinsot/view/picture_bounds.h"

namespace poinsot::node::parts {
namespace {

/**
 * For a viewer at +x: where ω's name stands beside its arrow, on the side away from L; on L's right while the two are
 * parallel. It passes quickly, but without a jump, from one side to the other.
 */
Eigen::Vector3d besideOmega(const Eigen::Vector3d& omega_metres, const Eigen::Vector3d& momentum_world) {
  const Eigen::Vector3d l = momentum_world.normalized();
  const Eigen::Vector2d to_its_right = Eigen::Vector2d(l.z(), -l.y()).stableNormalized();
  const double lean = (omega_metres - omega_metres.dot(l) * l).tail<2>().dot(to_its_right);
  const double side = layout::kBesideArrow * std::clamp((lean + 0.06) / 0.02, -1.0, 1.0);
  return {layout::kBeforeLines, side * to_its_right.x(), side * to_its_right.y()};
}

/**
 * For a viewer at +x who looks down a little, and straight at the picture in world axes: where Ω's name stands from its
 * bead, outwards as he sees it, and before the ellipsoids also while the bead is behind them; world axes [radii of the
 * picture].
 */
Eigen::Vector3d besideBead(const Eigen::Vector3d& bead) {
  using namespace layout;
  const double before = kBeforeSurfaces + std::max(0.0, kBeforeSurfaces - bead.x());
  const Eigen::Vector2d seen(bead.y() + kLooksAside * bead.x(), bead.z() - kLooksDown * bead.x());
  const Eigen::Vector2d outwards = kBesideBead * (seen + Eigen::Vector2d(0.04, 0.02)).normalized();
  return {before, outwards.x() - kLooksAside * before, outwards.y() + kLooksDown * before};
}

/** Puts the arrow of L, and its name. */
void appendArrow(const Subject& subject, const Eigen::Vector3d& momentum_world, const Eigen::Vector3d& torque_world,
                 bool shown, Canvas& canvas) {
  const MarkerFactory& factory = subject.factory;
  const std::string& space = factory.frames().space;
  const Eigen::Vector3d tip = subject.frame.scale.metres_per_angular_momentum * momentum_world;
  // Beyond the tip; where the torque's arrow begins there, on its other side.
  const double end_on = std::pow(tip.stableNormalized().x(), 2);  // 1: the arrow's head hides what is behind the tip
  Eigen::Vector3d symbol_from_tip = 0.12 * tip + layout::kBesideTorque * end_on * Eigen::Vector3d::UnitZ();
  if (!torque_world.isZero(0)) {
    const Eigen::Vector3d away = 2 * tip.stableNormalized() - torque_world.stableNormalized();
    symbol_from_tip = layout::kBesideTorque * (1 + end_on) * Eigen::Vector3d(0.5, away.y(), away.z()).normalized();
  }
  canvas.show(shown, factory.arrow(factory.ns(names::kSpace, names::kAngularMomentum), 0, space,
                                   Eigen::Vector3d::Zero(), tip, palette::kAngularMomentum));
  canvas.show(shown, factory.text(kMomentumSymbol, space, tip + symbol_from_tip, "L", layout::kSymbolHeight,
                                  palette::kAngularMomentum));
}

}  // namespace

double beadSymbolDepth(const Subject& subject) {
  double depth = layout::kTitleDepth;
  if (subject.polhode.branches.empty()) return depth;
  const Eigen::Quaterniond principal_to_world = subject.frame.model_orientation * subject.inertia.axes();
  for (const Eigen::Vector3d& omega : subject.polhode.branches.front().points) {
    const Eigen::Vector3d bead = subject.radii() * (principal_to_world * omega);
    const Eigen::Vector3d symbol = bead + besideBead(bead);
    const double larger = 1 + std::max(0.0, symbol.x()) / layout::kViewerDistance;
    depth = std::max(depth, layout::kBelowSymbol + larger * (layout::kLooksDown * symbol.x() - symbol.z()));
  }
  return depth;
}

void appendSpin(const Subject& subject, const Now& now, Canvas& canvas) {
  using namespace layout;
  const MarkerFactory& factory = subject.factory;
  const std::string& space = factory.frames().space;
  const std::string& model = factory.frames().model;
  const Eigen::Vector3d tip = subject.radii() * now.state.omega_world;
  canvas.put(
      factory.arrow(factory.ns(names::kSpace, names::kOmega), 0, space, Eigen::Vector3d::Zero(), tip, palette::kOmega));
  // The arrow ends on the surface, where its own ellipsoids hide it: a bead shows where, and a stub leads on to its
  // name.
  const Eigen::Vector3d outwards = tip.normalized();
  Marker end = factory.marker(factory.ns(kOmegaEnd), kOmegaEnd, Marker::SPHERE, space,
                              Eigen::Vector3d::Constant(kBeadDiameter), palette::kOmega);
  end.pose.position = toPoint(tip);
  canvas.put(end);
  Marker stub = factory.marker(factory.ns(kOmegaPointer), kOmegaPointer, Marker::LINE_LIST, space, {kStubWidth, 0, 0},
                               palette::kOmega);
  stub.points = {toPoint(tip), toPoint(tip + kPointerLength * outwards)};
  canvas.put(stub);
  const Eigen::Vector3d beyond = tip + (kPointerLength + kBeyondPointer) * outwards;
  canvas.put(factory.text(kOmegaSymbol, space, beyond + besideOmega(tip, now.state.momentum_world), "\xCF\x89",
                          kSymbolHeight, palette::kOmega));

  const Eigen::Vector3d place = subject.radii() * now.state.omega_body;
  Marker bead = factory.marker(factory.ns(names::kModel, names::kOmega), 0, Marker::SPHERE, model,
                               Eigen::Vector3d::Constant(kBeadDiameter), palette::kOmega);
  bead.pose.position = toPoint(place);
  canvas.put(bead);
  const Eigen::Quaterniond& to_world = subject.frame.model_orientation;
  canvas.put(factory.text(kModelOmegaSymbol, model, place + to_world.conjugate() * besideBead(to_world * place),
                          "\xCE\xA9", kSymbolHeight, palette::kOmega));
}

void appendStillMomentum(const Subject& subject, Canvas& canvas) {
  appendArrow(subject, subject.start.momentum_world, Eigen::Vector3d::Zero(), true, canvas);
}

void appendMomentum(const Subject& subject, const Now& now, Canvas& canvas) {
  appendArrow(subject, now.state.momentum_world, Eigen::Vector3d::Zero(), true, canvas);
}

void appendTorquedMomentum(const Subject& subject, const Now& now, Canvas& canvas) {
  const double length = subject.frame.scale.metres_per_angular_momentum * now.state.momentum_world.norm();
  appendArrow(subject, now.state.momentum_world, view::externalTorque(now.motion, now.state),
              length > layout::kLeastMomentum, canvas);
}

}  // namespace poinsot::node::parts
