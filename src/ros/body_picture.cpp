#include "poinsot/ros/body_picture.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <variant>

#include "poinsot/ros/cone_markers.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/ros/family_markers.h"
#include "poinsot/ros/palette.h"
#include "poinsot/ros/rolling_markers.h"
#include "poinsot/ros/shape_markers.h"
#include "poinsot/view/ellipsoids.h"
#include "poinsot/view/flips.h"
#include "poinsot/view/picture_bounds.h"
#include "poinsot/view/polhode.h"
#include "poinsot/view/separatrix.h"

namespace poinsot::node {
namespace {

using session::kSecond;
using session::Nanoseconds;
using session::Tick;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

// Lengths in metres; a picture's ellipsoids reach 1 m.
constexpr double kPolhodeWidth = 0.028;
constexpr double kTrailWidth = 0.045;
constexpr double kBeadDiameter = 0.10;
constexpr double kTitleDepth = 1.4;  // of the titles below the centres, at least
constexpr double kFiguresHeight = 0.19;
constexpr double kFiguresDepth = 0.13;  // below the title, and
constexpr double kFiguresDepthALine = 0.105;
constexpr double kTurnDepth = 0.38;  // of Montgomery's angle below the title
constexpr double kFlipsHeight = 0.17;
constexpr double kFlipsDepth = 0.3;  // below the title
constexpr float kSphereOverlay = 0.05f;
constexpr Nanoseconds kFlipsPause = kSecond / 10;
constexpr Nanoseconds kFiguresPause = kSecond / 4;  // a label that changed with every tick could not be read
constexpr double kPointerLength = 0.4;              // of ω's pointer beyond the surface

// A line lies this much outside the surface that it runs on, so as not to sink into it.
constexpr double kSeparatrixLift = 1.004;
constexpr double kTrailLift = 1.020;

constexpr double kTrailShare = 0.6;       // of the polhode: a trail that met itself would flicker
constexpr double kStrayTrailShare = 1.5;  // where Ω may leave the polhode, to be seen doing so
constexpr double kTrailSpacing = 0.03;    // m

// Of a body under torques.
constexpr double kTorquedTrailLength = 1.5;    // m: the newest stretch of its path
constexpr double kTorquedTrailHeight = 0.026;  // m above the surface
constexpr double kPathHeight = 0.016;
constexpr double kPathWidth = 0.018;
constexpr std::size_t kPathPieces = kTrailIds - 1;
constexpr std::size_t kPiecePoints = 256;  // 16384 together
constexpr std::size_t kPathPiecesAtOnce = 16;
constexpr double kPathTolerance = 0.002;  // m
constexpr double kPathSpacing = 0.2;      // m, at most
constexpr Nanoseconds kPathPause = kSecond / 4;
constexpr int kPolhodePoints = 64;                 // the middle of a chord of a circle of 1 m is 1 mm inside it
constexpr int kSeparatrixPoints = 48;              // 2 mm
constexpr Nanoseconds kCurvesPause = kSecond / 4;  // a curve that changes is sent that often at least,
constexpr double kCurvesChange = 0.002;            // and as soon as a semi-axis has changed by so much, relatively
constexpr double kLeastPicture = 0.002;            // m: a body nearly at rest has no ellipsoids to look at
constexpr double kLeastMomentum = 0.005;           // m, of L's arrow
constexpr double kDeepestTitle = 1.9;              // m: below it, the picture would become small
constexpr double kLeastStandIn = 0.3;              // m, half a diagonal of a heavy body's box

constexpr double kBesideArrow = 0.24;  // m
constexpr double kBesideTorque = 0.25;
constexpr double kBesideBead = 0.28;
constexpr double kBeforeLines = 0.15;  // towards the viewer
constexpr double kLooksDown = 0.48;    // the viewer, by so much per metre
constexpr double kLooksAside = 0.37;   // at the picture in body axes, as he looks straight at the other
constexpr double kViewerDistance = 6;  // m, about
constexpr double kBeforeSurfaces = 0.45;

/**
 * For a viewer at +x: where ω's name stands beside its arrow, on the side away from L; on L's right while the two are
 * parallel. It passes quickly, but without a jump, from one side to the other.
 */
Eigen::Vector3d besideOmega(const Eigen::Vector3d& omega_metres, const Eigen::Vector3d& momentum_world) {
  const Eigen::Vector3d l = momentum_world.normalized();
  const Eigen::Vector2d to_its_right = Eigen::Vector2d(l.z(), -l.y()).stableNormalized();
  const double lean = (omega_metres - omega_metres.dot(l) * l).tail<2>().dot(to_its_right);
  const double side = kBesideArrow * std::clamp((lean + 0.06) / 0.02, -1.0, 1.0);
  return {kBeforeLines, side * to_its_right.x(), side * to_its_right.y()};
}

/**
 * For a viewer at +x who looks down a little, and straight at the picture in world axes: where Ω's name stands from its
 * bead, outwards as he sees it, and before the ellipsoids also while the bead is behind them; world axes [m].
 */
Eigen::Vector3d besideBead(const Eigen::Vector3d& bead) {
  const double before = kBeforeSurfaces + std::max(0.0, kBeforeSurfaces - bead.x());
  const Eigen::Vector2d seen(bead.y() + kLooksAside * bead.x(), bead.z() - kLooksDown * bead.x());
  const Eigen::Vector2d outwards = kBesideBead * (seen + Eigen::Vector2d(0.04, 0.02)).normalized();
  return {before, outwards.x() - kLooksAside * before, outwards.y() + kLooksDown * before};
}

/** How far below the picture in body axes a title is clear of Ω's name, wherever on the polhode that is [m]. */
double beadSymbolDepth(const Eigen::Quaterniond& principal_to_world, double metres, const view::Polhode& polhode) {
  constexpr double kClearance = 0.5 * (kSymbolHeight + kTitleHeight) + 0.08;
  double depth = 0;
  if (polhode.branches.empty()) return depth;
  for (const Eigen::Vector3d& omega : polhode.branches.front().points) {
    const Eigen::Vector3d bead = metres * (principal_to_world * omega);
    const Eigen::Vector3d symbol = bead + besideBead(bead);
    const double larger = 1 + std::max(0.0, symbol.x()) / kViewerDistance;
    depth = std::max(depth, kClearance + larger * (kLooksDown * symbol.x() - symbol.z()));
  }
  return depth;
}

std::string formatted(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string flipsInWords(const view::Flips& flips, bool only_one) {
  const bool next = std::isfinite(flips.to_next);
  const std::string when = next ? formatted("in %.1f s", flips.to_next) : "";
  if (only_one)
    return next ? "its only flip " + when : flips.since_start != 0 ? "flip 1, its only one" : "no flip to come";
  const std::string next_words = next ? "next flip " + when : "";
  if (flips.since_start == 0) return next_words;
  return formatted("flip %.0f", static_cast<double>(flips.since_start)) + ", next " + when;
}

std::string methodOf(const MotionSetup& setup) {
  if (!setup.step) return setup.method;
  return setup.method +
         (*setup.step < 1 ? formatted(", step %.3g ms", 1e3 * *setup.step) : formatted(", step %.3g s", *setup.step));
}

view::Trail trailOf(const Motion& motion, const view::Polhode& polhode, double metres_per_radian_per_second) {
  if (motion.torques()) {
    return {2 + static_cast<std::size_t>(kTorquedTrailLength / kTrailSpacing), kTorquedTrailLength, kTrailSpacing};
  }
  double length = 0;
  if (!polhode.branches.empty()) {
    const std::vector<Eigen::Vector3d>& points = polhode.branches.front().points;
    for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  }
  length *= (motion.inClosedForm() ? kTrailShare : kStrayTrailShare) * metres_per_radian_per_second;
  return {2 + static_cast<std::size_t>(length / kTrailSpacing), length, kTrailSpacing};
}

const GravityTorque* weightOf(const scene::Body& body) {
  for (const Effect& effect : body.effects) {
    if (const auto* weight = std::get_if<GravityTorque>(&effect)) return weight;
  }
  return nullptr;
}

/** How a body on a pivot would look as a box: with the moments about its centre of mass, by Steiner. */
std::optional<Assembly> boxOnPivot(const PrincipalInertia& inertia, const GravityTorque& weight) {
  const Eigen::Vector3d& c = weight.centre_of_mass;
  const Eigen::Matrix3d about_centre =
      inertia.tensor() - weight.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(about_centre);
  const Eigen::Vector3d& moments = solver.eigenvalues();
  if (!moments.allFinite() || !(moments.minCoeff() > 0)) return std::nullopt;  // no body has these
  Eigen::Matrix3d axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) *= -1;
  const Assembly unit = shapes::equivalentBox(moments, Eigen::Quaterniond(axes));
  // Sides wᵢ give moments whose sum is m|w|²/6: half the diagonal is √(3 Σμᵢ/(2m)).
  const double radius = std::sqrt(1.5 * moments.sum() / weight.mass);
  Solid box = unit.parts().front();
  box.size *= std::clamp(radius, kLeastStandIn, 1.0) / unit.boundingRadius();
  return Assembly({box});
}

Assembly shapeOf(const scene::Body& body) {
  if (body.shape) return *body.shape;
  if (const GravityTorque* weight = weightOf(body)) {
    if (const std::optional<Assembly> box = boxOnPivot(body.inertia, *weight)) return *box;
  }
  return shapes::equivalentBox(body.inertia.moments(), body.inertia.axes());
}

/** Of the centre of mass, from the body's origin. */
Eigen::Vector3d shapePositionOf(const scene::Body& body) {
  const GravityTorque* weight = weightOf(body);
  if (body.shape || !weight) return body.shape_position;
  return weight->centre_of_mass;
}

/** Whether `pause` has gone by; stamps may begin anew. */
bool due(const std::optional<Nanoseconds>& last, Nanoseconds now, Nanoseconds pause) {
  return !last || now < *last || now >= *last + pause;
}

bool differ(double a, double b) {
  return std::abs(a - b) > kCurvesChange * b;
}

}  // namespace

BodyPicture::BodyPicture(const scene::Body& body, const Motion& motion, const names::Frames& frames, Detail detail,
                         const std::optional<view::PictureFrame>& keep)
    : factory_(body.name, frames),
      name_(body.name),
      start_(Motion(motion).at(0)),
      inertia_(body.inertia),
      appearance_(body.appearance),
      shape_(shapeOf(body)),
      shape_position_(shapePositionOf(body)),
      method_(methodOf(motion.setup())),
      torqued_(motion.torques() != nullptr),
      closed_form_(motion.closedForm() ? std::make_optional(*motion.closedForm()) : std::nullopt),
      may_flip_(closed_form_ && view::flipsOf(*closed_form_, 0, 1).flips),
      momentum_is_constant_(motion.conservesMomentum()),
      omega_principal_(inertia_.toPrincipal(start_.omega_body)),
      polhode_(view::polhode(inertia_.moments(), omega_principal_, kPolhodePoints)),
      frame_{{}, view::pictureScale(inertia_.moments(), omega_principal_), {}, 0},
      trail_(trailOf(motion, polhode_, frame_.scale.metres_per_radian_per_second)),
      path_(kPathPieces, kPiecePoints, kPathTolerance, kPathSpacing) {
  const double radius = shape_position_.norm() + shape_.boundingRadius();
  if (keep) {
    frame_ = *keep;
  } else if (torqued_ && detail == Detail::pictures) {
    frame_.bounds = view::pictureBoundsOf(motion);
    frame_.scale = view::pictureScale(frame_.bounds.semi_axis, frame_.bounds.momentum);
  }
  const auto is_inside = [](const Effect& effect) { return std::holds_alternative<InternalDissipation>(effect); };
  path_rides_ = std::all_of(body.effects.begin(), body.effects.end(), is_inside);
  if (!keep) {
    frame_.layout = view::layoutOf(start_.position, radius, inertia_.moments(), inertia_.axes(), polhode_,
                                   omega_principal_, inertia_.toPrincipal(frame_.bounds.omega_later));
  }
  if (torqued_) {
    effects_.emplace(factory_, motion,
                     EffectMarkers::Sizes{shape_.boundingRadius(), radius, frame_.bounds.torque,
                                          frame_.scale.metres_per_angular_momentum});
  }
  if (!keep) frame_.title_depth = titleDepth(radius);  // below what shows the effects
}

double BodyPicture::titleDepth(double body_radius) const {
  return std::max({kTitleDepth, body_radius + 0.3, effects_ ? std::min(effects_->depth(), kDeepestTitle) : 0,
                   beadSymbolDepth(frame_.layout.model_orientation * inertia_.axes(),
                                   frame_.scale.metres_per_radian_per_second, polhode_)});
}

void BodyPicture::appendStatic(MarkerArray& out) const {
  if (still_.markers.empty()) still_ = makeStatic();
  out.markers.insert(out.markers.end(), still_.markers.begin(), still_.markers.end());
}

MarkerArray BodyPicture::makeStatic() const {
  MarkerArray out;
  for (Marker& part : shapeMarkers(appearance_, shape_, shape_position_)) {
    part.header.frame_id = factory_.frames().body;
    part.ns = factory_.ns(names::kShape);
    part.frame_locked = true;
    out.markers.push_back(part);
  }
  appendTitles(out);
  if (effects_) effects_->appendStatic(out);
  if (torqued_ || atRest()) return out;  // nothing more that stands still
  const std::vector<view::Curve> separatrix =
      view::separatrix(inertia_.moments(), start_.kinetic_energy, kSeparatrixPoints);
  for (const Picture& picture : pictures()) {
    appendEllipsoids(picture, start_.kinetic_energy, start_.momentum_world.squaredNorm(), out);
    appendCurves(picture, polhode_, separatrix, out);
  }
  const double metres = frame_.scale.metres_per_radian_per_second;
  appendFamily(factory_, inertia_, omega_principal_, metres, out);
  // Below the picture in body axes, where the polhode is: below the other one the next body's L may stand.
  appendRolling(factory_, *closed_form_, metres, belowTitle(frame_.layout.model_centre, kTurnDepth), out);
  appendCones(factory_, *closed_form_, inertia_, metres, out);
  if (momentum_is_constant_) {
    for (const Marker& m : momentumMarkers(start_.momentum_world, Eigen::Vector3d::Zero())) out.markers.push_back(m);
  }
  return out;
}

void BodyPicture::appendEllipsoids(const Picture& picture, double kinetic_energy, double momentum_squared,
                                   MarkerArray& out) const {
  const double metres = frame_.scale.metres_per_radian_per_second;
  const auto add = [&](const char* what, const Eigen::Vector3d& semi_axes, const std_msgs::ColorRGBA& colour) {
    Marker m = factory_.marker(factory_.ns(picture.name, what), 0, Marker::SPHERE, picture.body_frame);
    m.pose.orientation = toQuaternion(inertia_.axes());
    m.scale = toVector3(2 * metres * semi_axes);  // a SPHERE's scale is its diameter
    m.color = colour;
    m.frame_locked = true;
    out.markers.push_back(m);
  };
  // A sphere's two are one: of two opaque ones now the one would be seen, now the other.
  const bool is_sphere = inertia_.moments().minCoeff() == inertia_.moments().maxCoeff();
  add(names::kEnergyEllipsoid, view::energySemiAxes(inertia_.moments(), kinetic_energy), palette::energy());
  add(names::kMomentumEllipsoid, view::momentumSemiAxes(inertia_.moments(), momentum_squared),
      palette::translucent(palette::momentumEllipsoid(), is_sphere ? kSphereOverlay : 1));
}

void BodyPicture::appendCurves(const Picture& picture, const view::Polhode& polhode,
                               const std::vector<view::Curve>& separatrix, MarkerArray& out) const {
  const double metres = frame_.scale.metres_per_radian_per_second;
  const auto add = [&](const char* what, int id, const view::Curve& curve, double lift, double width,
                       const std_msgs::ColorRGBA& colour) {
    const bool is_point = curve.points.size() == 1;  // RViz draws no line through a single point
    Marker m = factory_.marker(factory_.ns(picture.name, what), id, is_point ? Marker::SPHERE_LIST : Marker::LINE_STRIP,
                               picture.body_frame);
    m.pose.orientation = toQuaternion(inertia_.axes());
    for (const Eigen::Vector3d& p : curve.points) m.points.push_back(toPoint(lift * metres * p));
    if (curve.closed && !is_point) m.points.push_back(m.points.front());
    m.scale = is_point ? toVector3(Eigen::Vector3d::Constant(2 * width)) : toVector3({width, 0, 0});
    m.color = colour;
    m.frame_locked = true;
    out.markers.push_back(m);
  };
  for (std::size_t i = 0; i < polhode.branches.size(); ++i) {
    add(names::kPolhode, static_cast<int>(i), polhode.branches[i], kPolhodeLift, kPolhodeWidth,
        i == 0 ? palette::polhode() : palette::mirrorPolhode());
  }
  for (std::size_t i = 0; i < separatrix.size(); ++i) {
    add(names::kSeparatrix, static_cast<int>(i), separatrix[i], kSeparatrixLift, kSeparatrixWidth,
        palette::separatrix());
  }
}

Eigen::Vector3d BodyPicture::belowTitle(const Eigen::Vector3d& centre, double depth) const {
  return centre + Eigen::Vector3d(depth, 0, -frame_.title_depth - 0.75 * depth);
}

void BodyPicture::appendTitles(MarkerArray& out) const {
  const Eigen::Vector3d down(0, 0, -frame_.title_depth);
  out.markers.push_back(factory_.text(kBodyTitle, names::kWorld, start_.position + down, name_, kTitleHeight));
  if (atRest()) return;
  out.markers.push_back(factory_.text(kSpaceTitle, factory_.frames().space, down, "in world axes", kTitleHeight));
  out.markers.push_back(
      factory_.text(kModelTitle, names::kWorld, frame_.layout.model_centre + down, "in body axes", kTitleHeight));
}

std::array<Marker, 2> BodyPicture::momentumMarkers(const Eigen::Vector3d& momentum_world,
                                                   const Eigen::Vector3d& torque_world) const {
  const Eigen::Vector3d tip = frame_.scale.metres_per_angular_momentum * momentum_world;
  Marker l = factory_.arrow(factory_.ns(names::kSpace, names::kAngularMomentum), 0, factory_.frames().space,
                            Eigen::Vector3d::Zero(), tip);
  // Beyond the tip; where the torque's arrow begins there, on its other side.
  const double end_on = std::pow(tip.stableNormalized().x(), 2);  // 1: the arrow's head hides what is behind the tip
  Eigen::Vector3d symbol_from_tip = 0.12 * tip + kBesideTorque * end_on * Eigen::Vector3d::UnitZ();
  if (!torque_world.isZero(0)) {
    const Eigen::Vector3d away = 2 * tip.stableNormalized() - torque_world.stableNormalized();
    symbol_from_tip = kBesideTorque * (1 + end_on) * Eigen::Vector3d(0.5, away.y(), away.z()).normalized();
  }
  Marker symbol = factory_.text(kMomentumSymbol, factory_.frames().space, tip + symbol_from_tip, "L", kSymbolHeight);
  l.color = symbol.color = palette::angularMomentum();
  return {l, symbol};
}

void BodyPicture::appendFigures(const Tick& tick, const Figures& figures, MarkerArray& out) {
  if (!due(figures_shown_, tick.stamp, kFiguresPause)) return;
  figures_shown_ = tick.stamp;
  // Under torques there is nothing to compare with, and the energy is meant to change.
  const std::string what = torqued_ ? formatted("\nenergy %.4g J", figures.kinetic_energy)
                                    : formatted("\nattitude error %.1e rad", figures.attitude_error) +
                                          formatted("\nenergy drift %+.1e", figures.energy_drift);
  const std::string words = method_ + what +
                            (std::isnan(figures.cost) ? "" : formatted("\ncost %.3g us per s", 1e6 * figures.cost)) +
                            (flips_.empty() ? "" : "\n" + flips_);
  tracker_.removeOne(factory_.ns(kFlips), kFlips, out);
  const auto lines = 1 + std::count(words.begin(), words.end(), '\n');
  const double depth = kFiguresDepth + kFiguresDepthALine * static_cast<double>(lines);  // of its middle
  Marker label = factory_.text(kFigures, names::kWorld, belowTitle(start_.position, depth), words, kFiguresHeight);
  label.header.stamp = toTime(tick.stamp);
  out.markers.push_back(label);
}

void BodyPicture::appendFlips(const Tick& tick, const Motion& motion, double time, MarkerArray& out) {
  if (!may_flip_ || !motion.inClosedForm()) return;  // another method's flips are not those of the closed form
  if (tick.time_rate != 0) direction_ = tick.time_rate;
  if (!due(flips_told_, tick.stamp, kFlipsPause)) return;
  flips_told_ = tick.stamp;
  flips_ =
      flipsInWords(view::flipsOf(*motion.closedForm(), time, direction_), polhode_.regime == view::Regime::separatrix);
  if (figures_shown_) return;  // they tell it
  tracker_.put(factory_.text(kFlips, names::kWorld, belowTitle(start_.position, kFlipsDepth), flips_, kFlipsHeight),
               out);
}

void BodyPicture::appendMoving(const Tick& tick, const Motion& motion, const MotionState& state, MarkerArray& out) {
  if (segment_ != tick.segment) {
    segment_ = tick.segment;
    clearTrail();
  }
  if (atRest()) return;
  const std::size_t first = out.markers.size();
  if (!torqued_) {
    appendFlips(tick, motion, state.time, out);
    appendOmega(state, out);
    appendTrail(kTrailLift * frame_.scale.metres_per_radian_per_second * state.omega_body, out);
    if (!momentum_is_constant_) {
      for (const Marker& m : momentumMarkers(state.momentum_world, Eigen::Vector3d::Zero())) out.markers.push_back(m);
    }
  } else {
    const Eigen::Vector3d torque_world = view::externalTorque(motion, state);
    appendMovingConstruction(tick, state, torque_world, out);
    effects_->appendMoving(state, torque_world, tracker_, out);
  }
  for (std::size_t i = first; i < out.markers.size(); ++i) out.markers[i].header.stamp = toTime(tick.stamp);
}

void BodyPicture::appendMovingConstruction(const Tick& tick, const MotionState& state,
                                           const Eigen::Vector3d& torque_world, MarkerArray& out) {
  const double metres = frame_.scale.metres_per_radian_per_second;
  const Eigen::Vector3d& moments = inertia_.moments();
  const Eigen::Vector3d omega = inertia_.toPrincipal(state.omega_body);
  // Of the body alone, without the slug that may be inside: Ω lies on these.
  const Eigen::Vector3d momentum = moments.cwiseProduct(omega);
  const double kinetic_energy = 0.5 * momentum.dot(omega), momentum_squared = momentum.squaredNorm();

  const auto put = [this, &out](const MarkerArray& markers) {
    for (const Marker& m : markers.markers) tracker_.put(m, out);
  };
  if (frame_.scale.metres_per_angular_momentum * state.momentum_world.norm() > kLeastMomentum) {
    for (const Marker& m : momentumMarkers(state.momentum_world, torque_world)) tracker_.put(m, out);
  } else {
    tracker_.remove(factory_.ns(names::kSpace, names::kAngularMomentum), 0, out);
    tracker_.removeOne(factory_.ns(kMomentumSymbol), kMomentumSymbol, out);
  }

  appendPath(tick, metres * state.omega_body, out);
  if (!(metres * momentum.norm() / moments.minCoeff() > kLeastPicture)) {
    for (const char* picture : {names::kSpace, names::kModel}) {
      for (const char* what :
           {names::kEnergyEllipsoid, names::kMomentumEllipsoid, names::kPolhode, names::kSeparatrix, names::kOmega}) {
        tracker_.remove(factory_.ns(picture, what), 0, out);
      }
    }
    for (const LabelId id : {kOmegaPointer, kOmegaSymbol, kModelOmegaSymbol}) {
      tracker_.removeOne(factory_.ns(id), id, out);
    }
    curves_shown_.reset();
    return;
  }

  MarkerArray markers;
  appendOmega(state, markers);
  for (const Picture& picture : pictures()) appendEllipsoids(picture, kinetic_energy, momentum_squared, markers);
  put(markers);
  const double energy_size = std::sqrt(kinetic_energy), momentum_size = std::sqrt(momentum_squared);
  if (!due(curves_shown_, tick.stamp, kCurvesPause) && !differ(energy_size, curves_energy_size_) &&
      !differ(momentum_size, curves_momentum_size_)) {
    return;
  }
  curves_shown_ = tick.stamp;
  curves_energy_size_ = energy_size;
  curves_momentum_size_ = momentum_size;
  const view::Polhode polhode = view::polhode(moments, omega, kPolhodePoints);
  const std::vector<view::Curve> separatrix = view::separatrix(moments, kinetic_energy, kSeparatrixPoints);
  MarkerArray curves;
  for (const Picture& picture : pictures()) {
    appendCurves(picture, polhode, separatrix, curves);
    // Their number depends on what kind of curve it is.
    tracker_.remove(factory_.ns(picture.name, names::kPolhode), static_cast<int>(polhode.branches.size()), out);
    tracker_.remove(factory_.ns(picture.name, names::kSeparatrix), static_cast<int>(separatrix.size()), out);
  }
  put(curves);
}

void BodyPicture::appendOmega(const MotionState& state, MarkerArray& out) const {
  const double metres = frame_.scale.metres_per_radian_per_second;
  const Eigen::Vector3d in_space = metres * state.omega_world;
  const Eigen::Vector3d in_model = metres * state.omega_body;
  const std::string& space = factory_.frames().space;
  const std::string& model = factory_.frames().model;

  Marker omega = factory_.arrow(factory_.ns(names::kSpace, names::kOmega), 0, space, Eigen::Vector3d::Zero(), in_space);
  omega.color = palette::omega();
  out.markers.push_back(omega);

  // The arrow ends on the surface, where its own ellipsoids hide it: a pointer leads on to its name.
  const Eigen::Vector3d outwards = in_space.normalized();
  Marker pointer =
      factory_.arrow(factory_.ns(kOmegaPointer), kOmegaPointer, space, in_space, in_space + kPointerLength * outwards);
  pointer.color = palette::omega();
  out.markers.push_back(pointer);
  Marker symbol = factory_.text(
      kOmegaSymbol, space, in_space + (kPointerLength + 0.1) * outwards + besideOmega(in_space, state.momentum_world),
      "\xCF\x89", kSymbolHeight);
  symbol.color = palette::omega();
  out.markers.push_back(symbol);

  Marker bead = factory_.marker(factory_.ns(names::kModel, names::kOmega), 0, Marker::SPHERE, model);
  bead.pose.position = toPoint(in_model);
  bead.scale = toVector3(Eigen::Vector3d::Constant(kBeadDiameter));
  bead.color = palette::omega();
  out.markers.push_back(bead);
  Marker bead_symbol = factory_.text(
      kModelOmegaSymbol, model,
      in_model + frame_.layout.model_orientation.conjugate() * besideBead(frame_.layout.model_orientation * in_model),
      "\xCE\xA9", kSymbolHeight);
  bead_symbol.color = palette::omega();
  out.markers.push_back(bead_symbol);
}

void BodyPicture::appendTrail(const Eigen::Vector3d& place, MarkerArray& out) {
  trail_.add(place);
  if (trail_.size() < 2) {
    // After a jump the old trail would stay where it was.
    tracker_.removeOne(factory_.ns(names::kTrail), 0, out);
    return;
  }
  Marker trail = factory_.marker(factory_.ns(names::kTrail), 0, Marker::LINE_STRIP, factory_.frames().model);
  trail.points.reserve(trail_.size());
  trail.colors.reserve(trail_.size());
  for (std::size_t i = 0; i < trail_.size(); ++i) {
    trail.points.push_back(toPoint(trail_[i]));
    const float youth = static_cast<float>(i + 1) / static_cast<float>(trail_.size());
    trail.colors.push_back(palette::translucent(palette::omega(), youth));
  }
  trail.scale.x = kTrailWidth;
  trail.color = palette::translucent(palette::omega(), 0.99f);  // opaque, RViz would not blend the points' colours
  tracker_.put(trail, out);
}

void BodyPicture::appendPath(const Tick& tick, const Eigen::Vector3d& omega_metres, MarkerArray& out) {
  // Where an ellipsoid is long and thin, a larger Ω would be no higher above its flanks: lifted along the normal
  // instead, of which each ellipsoid has its own.
  const Eigen::Quaterniond& axes = inertia_.axes();
  const Eigen::Vector3d energy_normal = inertia_.moments().cwiseProduct(axes.conjugate() * omega_metres);
  const Eigen::Vector3d momentum_normal = inertia_.moments().cwiseProduct(energy_normal);
  const Eigen::Vector3d normal =
      axes * (energy_normal.stableNormalized() + momentum_normal.stableNormalized()).stableNormalized();
  appendTrail(omega_metres + kTorquedTrailHeight * normal, out);
  const std::size_t before = path_.endPiece();
  // While a slug takes momentum up or gives it back, |MΩ| changes: the spiral is kept on an ellipsoid of 1 m and drawn
  // on the present one, which would hide it or leave it in the air else.
  const double semi_axis = energy_normal.norm() / inertia_.moments().minCoeff();
  const double size = path_rides_ && semi_axis > 0 ? semi_axis / view::kPictureRadius : 1;
  path_.add(omega_metres / size + kPathHeight * normal);
  const std::string ns = factory_.ns(names::kTrail);
  if (path_jumped_) tracker_.remove(ns, 1, out);
  const auto send = [&](std::size_t k) {
    const std::vector<Eigen::Vector3d>& points = path_.piece(k);
    if (points.size() < 2) return;
    // A new piece takes the place of the one that has gone.
    Marker piece =
        factory_.marker(ns, 1 + static_cast<int>(k % kPathPieces), Marker::LINE_STRIP, factory_.frames().model);
    piece.points.reserve(points.size());
    for (const Eigen::Vector3d& p : points) piece.points.push_back(toPoint(size * p));
    piece.scale.x = kPathWidth;
    piece.color = palette::path();
    piece.frame_locked = true;
    tracker_.put(piece, out);
  };
  const std::size_t last = path_.endPiece() - 1;
  if (path_.endPiece() > before && before > 0 && !path_jumped_) send(before - 1);  // now that it is whole
  path_jumped_ = false;
  if (!due(path_shown_, tick.stamp, kPathPause)) return;
  path_shown_ = tick.stamp;
  send(last);
  if (last == path_.firstPiece()) return;
  if (differ(size, path_size_)) {
    path_size_ = size;
    const std::size_t first = std::max(path_.firstPiece(), last - std::min(last, kPathPiecesAtOnce));
    for (std::size_t k = first; k < last; ++k) send(k);
    if (first == path_.firstPiece()) return;
  }
  // The others once more in turn, for who came later.
  path_turn_ = path_turn_ + 1 < last && path_turn_ + 1 >= path_.firstPiece() ? path_turn_ + 1 : path_.firstPiece();
  send(path_turn_);
}

void BodyPicture::clearTrail() {
  trail_.clear();
  flips_told_.reset();
  if (effects_) effects_->clearWay();
  path_.clear();
  path_jumped_ = true;
  path_shown_.reset();
}

}  // namespace poinsot::node
