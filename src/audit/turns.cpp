#include "turns.h"

#include <cmath>

#include "poinsot/audit/free_motion.h"

namespace poinsot::audit {

void compareTurn(Judge& judge, const Interval& v, const Turn& turn, double allowance) {
  const double rate = v.a.omega_body.norm();
  const double bound = turn.error + allowance + rate * v.rounding + 4e-15;
  const Eigen::Quaterniond expected = v.a.attitude * rotationBy(turn.theta);
  judge.compare(angleBetween(expected, v.b.attitude), bound, seconds(v.b.stamp), [&]() -> std::string {
    const Eigen::Vector3d actual = rotationVector(v.a.attitude.conjugate() * v.b.attitude);
    const double wanted = turn.theta.squaredNorm();
    if (v.duration == 0) {
      return text("time stands still (time_rate %g) but R turns by %.3g rad between two messages", v.a.time_rate,
                  actual.norm());
    }
    const double ratio = actual.dot(turn.theta) / wanted;
    if ((actual - ratio * turn.theta).norm() < 0.05 * std::abs(ratio - 1) * std::sqrt(wanted)) {
      return text("R turns %.4f times as far as time_rate·Ω says (%.6g rad in %.6g s of stamp)", ratio, actual.norm(),
                  v.stamps);
    }
    const double missed = (actual - turn.theta).norm();
    const Eigen::Vector3d from_world = v.a.attitude.conjugate() * turn.theta;
    if ((actual - from_world).norm() < 0.1 * missed) return "omega_body looks like the angular velocity in world axes";
    const Eigen::Vector3d inverse = rotationVector(v.a.attitude * v.b.attitude.conjugate());
    if ((inverse - turn.theta).norm() < 0.1 * missed)
      return "the attitude looks inverted: world to body, not body to world";
    return text("R turns by %.6g rad in %.6g s of stamp, time_rate·Ω says %.6g rad; they differ by %.3g rad",
                actual.norm(), v.stamps, std::sqrt(wanted), missed);
  });
}

}  // namespace poinsot::audit
