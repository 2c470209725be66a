#include "markers/subject.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <variant>

#include "markers/layout.h"
#include "markers/parts.h"

namespace poinsot::node::parts {
namespace {

constexpr double kLeastStandIn = 0.3;  // m, half a diagonal of a heavy body's box: else the rod alone would be seen

/** At most one: the reader of scenes sees to that. */
std::optional<GravityTorque> weightOf(const scene::Body& body) {
  for (const Effect& effect : body.effects) {
    if (const auto* weight = std::get_if<GravityTorque>(&effect)) return *weight;
  }
  return std::nullopt;
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

Assembly shapeOf(const scene::Body& body, const std::optional<GravityTorque>& weight) {
  if (body.shape) return *body.shape;
  if (weight) {
    if (const std::optional<Assembly> box = boxOnPivot(body.inertia, *weight)) return *box;
  }
  return shapes::equivalentBox(body.inertia.moments(), body.inertia.axes());
}

}  // namespace

Subject::Subject(const scene::Body& body, const Motion& motion, const names::Frames& frames)
    : factory(body.name, frames),
      name(body.name),
      inertia(body.inertia),
      start(Motion(motion).at(0)),
      omega_principal(inertia.toPrincipal(start.omega_body)),
      polhode(view::polhode(inertia.moments(), omega_principal, layout::kPolhodePoints)),
      closed_form(motion.closedForm() ? std::make_optional(*motion.closedForm()) : std::nullopt),
      weight(weightOf(body)),
      orbit(motion.torques() && motion.torques()->gradient() ? std::make_optional(*motion.torques()->gradient())
                                                             : std::nullopt),
      translation(body.translation),
      wanted(body.pictures),
      is_pushed(isPushed(motion)),
      keeps_momentum(!motion.torques() && motion.conservesMomentum()),
      colour(body.colour),
      appearance(body.appearance),
      shape(shapeOf(body, weight)),
      shape_position(weight && !body.shape ? weight->centre_of_mass : body.shape_position),
      shape_radius(shape.boundingRadius()),
      reach(shape_position.norm() + shape_radius),
      frame() {
  frame.scale = view::pictureScale(inertia.moments(), omega_principal);
}

Eigen::Vector3d Subject::belowTitle(const Eigen::Vector3d& centre, double title_depth, double depth) const {
  const double metres = depth * frame.text * unit();
  return centre + Eigen::Vector3d(metres, 0, -title_depth - layout::kFallPerDepth * metres);
}

}  // namespace poinsot::node::parts
