#include <cmath>
#include <vector>

#include "markers/layout.h"
#include "markers/parts.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/ros/markers/palette.h"
#include "poinsot/view/ellipsoids.h"
#include "poinsot/view/polhode_family.h"
#include "poinsot/view/separatrix.h"

namespace poinsot::node::parts {
namespace {

constexpr float kSphereOverlay = 0.05f;
constexpr session::Nanoseconds kCurvesPause = session::kSecond / 4;

void appendEllipsoids(const Subject& subject, const Picture& picture, double kinetic_energy, double momentum_squared,
                      Canvas& canvas) {
  const double radii = subject.radii();
  const Eigen::Vector3d& moments = subject.inertia.moments();
  const auto put = [&](const char* what, const Eigen::Vector3d& semi_axes, const std_msgs::ColorRGBA& colour) {
    const Eigen::Vector3d diameters = 2 * radii * semi_axes;
    Marker m = locked(subject.factory.marker(subject.factory.ns(picture.name, what), 0, Marker::SPHERE,
                                             picture.body_frame, diameters, colour));
    m.pose.orientation = toQuaternion(subject.inertia.axes());
    canvas.put(m);
  };
  // The two ellipsoids of a sphere coincide: two opaque ones would flicker.
  const bool is_sphere = moments.minCoeff() == moments.maxCoeff();
  put(names::kEnergyEllipsoid, view::energySemiAxes(moments, kinetic_energy), palette::kEnergy);
  put(names::kMomentumEllipsoid, view::momentumSemiAxes(moments, momentum_squared),
      palette::translucent(palette::kMomentumEllipsoid, is_sphere ? kSphereOverlay : 1));
}

void appendCurves(const Subject& subject, const Picture& picture, const view::Polhode& polhode,
                  const std::vector<view::Curve>& separatrix, Canvas& canvas) {
  const auto put = [&](const char* what, std::size_t id, const view::Curve& curve, double lift, double width,
                       const std_msgs::ColorRGBA& colour) {
    Marker m = subject.factory.curve(subject.factory.ns(picture.name, what), static_cast<int>(id), picture.body_frame,
                                     curve, lift * subject.radii(), width, 2 * width, colour);
    m.pose.orientation = toQuaternion(subject.inertia.axes());
    canvas.put(m);
  };
  for (std::size_t i = 0; i < polhode.branches.size(); ++i) {
    put(names::kPolhode, i, polhode.branches[i], layout::kPolhodeLift, layout::kPolhodeWidth,
        i == 0 ? palette::kPolhode : palette::kMirrorPolhode);
  }
  for (std::size_t i = 0; i < separatrix.size(); ++i) {
    put(names::kSeparatrix, i, separatrix[i], layout::kSeparatrixLift, layout::kSeparatrixWidth, palette::kSeparatrix);
  }
}

/** Puts the ends of the principal axes beyond the ellipsoids, in the colours of the axes. */
void appendAxes(const Subject& subject, const Picture& picture, double kinetic_energy, double momentum_squared,
                Canvas& canvas) {
  constexpr double kPin = 0.13;
  const Eigen::Vector3d& moments = subject.inertia.moments();
  const Eigen::Vector3d surface =
      subject.radii() *
      view::energySemiAxes(moments, kinetic_energy).cwiseMax(view::momentumSemiAxes(moments, momentum_squared));
  Marker m = locked(subject.factory.marker(subject.factory.ns(picture.name, names::kAxes), 0, Marker::LINE_LIST,
                                           picture.body_frame, {layout::kAxisWidth, 0, 0}, palette::kPolhode));
  m.pose.orientation = toQuaternion(subject.inertia.axes());
  for (int axis = 0; axis < 3; ++axis) {
    for (const double end : {1.0, -1.0}) {
      m.points.push_back(toPoint(end * surface[axis] * Eigen::Vector3d::Unit(axis)));
      m.points.push_back(toPoint(end * (surface[axis] + kPin) * Eigen::Vector3d::Unit(axis)));
      m.colors.insert(m.colors.end(), 2, palette::kAxes[axis]);
    }
  }
  canvas.put(m);
}

void appendLines(const Subject& subject, int id, const std::vector<view::Curve>& curves, double width,
                 const std_msgs::ColorRGBA& colour, Canvas& canvas) {
  if (curves.empty()) return;
  const MarkerFactory& factory = subject.factory;
  Marker m = locked(factory.marker(factory.ns(names::kModel, names::kPolhodeFamily), id, Marker::LINE_LIST,
                                   factory.frames().model, {width, 0, 0}, colour));
  m.pose.orientation = toQuaternion(subject.inertia.axes());
  const double lifted = layout::kFamilyLift * subject.radii();
  for (const view::Curve& curve : curves) {
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      m.points.push_back(toPoint(lifted * curve.points[i]));
      m.points.push_back(toPoint(lifted * curve.points[(i + 1) % curve.points.size()]));
    }
  }
  canvas.put(m);
}

class TorquedConstruction : public Part {
 public:
  void appendMoving(const Subject& subject, const Now& now, Canvas& canvas) override {
    const Eigen::Vector3d& moments = subject.inertia.moments();
    const Eigen::Vector3d omega = subject.inertia.toPrincipal(now.state.omega_body);
    // Of the body alone, without the slug that may be inside: Ω lies on these.
    const Eigen::Vector3d momentum = moments.cwiseProduct(omega);
    if (!(subject.radii() * momentum.norm() / moments.minCoeff() > layout::kLeastPicture))
      return remove(subject, canvas);

    const double kinetic_energy = 0.5 * momentum.dot(omega), momentum_squared = momentum.squaredNorm();
    appendSpin(subject, now, canvas);
    for (const Picture& picture : subject.pictures()) {
      appendEllipsoids(subject, picture, kinetic_energy, momentum_squared, canvas);
    }
    const double energy_size = std::sqrt(kinetic_energy), momentum_size = std::sqrt(momentum_squared);
    const bool changed = differs(energy_size, energy_size_) || differs(momentum_size, momentum_size_);
    if (!curves_.due(now.tick.stamp, changed)) return;
    energy_size_ = energy_size;
    momentum_size_ = momentum_size;
    const view::Polhode polhode = view::polhode(moments, omega, layout::kPolhodePoints);
    const std::vector<view::Curve> separatrix = view::separatrix(moments, kinetic_energy, layout::kSeparatrixPoints);
    for (const Picture& picture : subject.pictures()) {  // their number depends on what kind of curve it is
      const auto branches = static_cast<int>(polhode.branches.size());
      canvas.remove(subject.factory.ns(picture.name, names::kPolhode), branches);
      canvas.remove(subject.factory.ns(picture.name, names::kSeparatrix), static_cast<int>(separatrix.size()));
    }
    for (const Picture& picture : subject.pictures()) {
      appendCurves(subject, picture, polhode, separatrix, canvas);
      appendAxes(subject, picture, kinetic_energy, momentum_squared, canvas);
    }
  }

  void sendAllNext() override { curves_.reset(); }

 private:
  void remove(const Subject& subject, Canvas& canvas) {
    for (const Picture& picture : subject.pictures()) {
      for (const char* what : {names::kEnergyEllipsoid, names::kMomentumEllipsoid, names::kPolhode, names::kSeparatrix,
                               names::kOmega, names::kAxes}) {
        canvas.remove(subject.factory.ns(picture.name, what), 0);
      }
    }
    for (const LabelId id : {kOmegaPointer, kOmegaSymbol, kOmegaEnd, kModelOmegaSymbol}) {
      canvas.remove(subject.factory.ns(id), id, id + 1);
    }
    curves_.reset();
  }

  Cadence curves_{kCurvesPause};
  double energy_size_ = 0, momentum_size_ = 0;  ///< √E and |MΩ| when the curves were sent
};

}  // namespace

void appendConstruction(const Subject& subject, Canvas& canvas) {
  const MotionState& start = subject.start;
  const std::vector<view::Curve> separatrix =
      view::separatrix(subject.inertia.moments(), start.kinetic_energy, layout::kSeparatrixPoints);
  for (const Picture& picture : subject.pictures()) {
    appendEllipsoids(subject, picture, start.kinetic_energy, start.momentum_world.squaredNorm(), canvas);
    appendCurves(subject, picture, subject.polhode, separatrix, canvas);
    appendAxes(subject, picture, start.kinetic_energy, start.momentum_world.squaredNorm(), canvas);
  }
}

void appendPolhodeFamily(const Subject& subject, Canvas& canvas) {
  const view::PolhodeFamily family = view::polhodeFamily(subject.inertia.moments(), subject.omega_principal);
  appendLines(subject, 0, family.members, layout::kFamilyWidth, palette::kPolhodeFamily, canvas);
  appendLines(subject, 1, family.separatrix, layout::kSeparatrixWidth, palette::kSeparatrix, canvas);
}

std::unique_ptr<Part> makeTorquedConstruction() {
  return std::make_unique<TorquedConstruction>();
}

}  // namespace poinsot::node::parts
