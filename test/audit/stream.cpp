#include "stream.h"

#include <cmath>
#include <memory>
#include <stdexcept>

namespace poinsot::test {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using visualization_msgs::Marker;

Quaterniond turn(const Vector3d& theta) {
  const double angle = theta.norm();
  return angle == 0 ? Quaterniond::Identity() : Quaterniond(Eigen::AngleAxisd(angle, theta / angle));
}

template <typename Message>
Message xyz(const Vector3d& v) {
  Message out;
  out.x = v.x();
  out.y = v.y();
  out.z = v.z();
  return out;
}

geometry_msgs::Quaternion wxyz(const Quaterniond& q) {
  geometry_msgs::Quaternion out;
  out.w = q.w();
  out.x = q.x();
  out.y = q.y();
  out.z = q.z();
  return out;
}

ros::Time stampTime(std::int64_t ns) {
  return ros::Time(static_cast<std::uint32_t>(ns / 1000000000), static_cast<std::uint32_t>(ns % 1000000000));
}

geometry_msgs::TransformStamped transform(const ros::Time& stamp, const std::string& parent, const std::string& child,
                                          const Vector3d& position, const Quaterniond& rotation) {
  geometry_msgs::TransformStamped t;
  t.header.stamp = stamp;
  t.header.frame_id = parent;
  t.child_frame_id = child;
  t.transform.translation = xyz<geometry_msgs::Vector3>(position);
  t.transform.rotation = wxyz(rotation);
  return t;
}

Marker marker(const std::string& ns, const std::string& frame, int type, const ros::Time& stamp = ros::Time()) {
  Marker m;
  m.header.frame_id = frame;
  m.header.stamp = stamp;
  m.ns = ns;
  m.type = type;
  m.pose.orientation.w = 1;
  return m;
}

}  // namespace

Truth symmetricTop(double a, double c, const Quaterniond& attitude, const Vector3d& omega_body) {
  const Vector3d momentum = attitude * Vector3d(a, a, c).cwiseProduct(omega_body);
  const Vector3d spin(0, 0, (1 - c / a) * omega_body.z());
  return [=](double t) {
    const Quaterniond q = (turn(momentum * (t / a)) * attitude * turn(spin * t)).normalized();
    return Moment{q, q.conjugate() * momentum / a + spin};
  };
}

Truth anyBody(const Matrix3d& tensor, const Quaterniond& attitude, const Vector3d& omega_body, double step,
              const Vector3d& torque_world) {
  struct Now {
    double t;
    Eigen::Vector4d q;
    Vector3d p;
  };
  const auto now = std::make_shared<Now>(Now{0, attitude.coeffs(), tensor * omega_body});
  const Matrix3d inverse = tensor.inverse();
  return [=](double t) {
    const int steps = static_cast<int>(std::ceil(std::abs(t - now->t) / step));
    const double h = steps > 0 ? (t - now->t) / steps : 0;
    const auto rate = [&](const Eigen::Vector4d& q, const Vector3d& p, Eigen::Vector4d& dq, Vector3d& dp) {
      const Vector3d w = inverse * p;
      dq = 0.5 * (Quaterniond(q) * Quaterniond(0, w.x(), w.y(), w.z())).coeffs();
      dp = p.cross(w) + Quaterniond(q).normalized().conjugate() * torque_world;
    };
    for (int i = 0; i < steps; ++i) {
      Eigen::Vector4d q1, q2, q3, q4;
      Vector3d p1, p2, p3, p4;
      rate(now->q, now->p, q1, p1);
      rate(now->q + 0.5 * h * q1, now->p + 0.5 * h * p1, q2, p2);
      rate(now->q + 0.5 * h * q2, now->p + 0.5 * h * p2, q3, p3);
      rate(now->q + h * q3, now->p + h * p3, q4, p4);
      now->q = (now->q + h / 6 * (q1 + 2 * q2 + 2 * q3 + q4)).normalized();
      now->p += h / 6 * (p1 + 2 * p2 + 2 * p3 + p4);
    }
    now->t = t;
    return Moment{Quaterniond(now->q), inverse * now->p};
  };
}

Truth drivenBody(const Matrix3d& tensor, const Quaterniond& attitude, const Vector3d& omega_body, const Driven& driven,
                 double step) {
  using Now = Eigen::Matrix<double, 10, 1>;  // q as x y z w, Ω, σ
  const auto time = std::make_shared<double>(0);
  const auto now = std::make_shared<Now>();
  *now << attitude.coeffs(), omega_body, driven.slug_at_rest ? Vector3d(0, 0, 0) : omega_body;
  const Matrix3d inverse = tensor.inverse();
  const auto momentOf = [](const Now& x) {
    return Moment{Quaterniond(x.head<4>()).normalized(), x.segment<3>(4), x.tail<3>()};
  };
  const auto rate = [=](double t, const Now& x) {
    const Moment m = momentOf(x);
    const Vector3d &w = m.omega_body, &s = m.slug_omega;
    const Vector3d drag = driven.slug_damping * (w - s);
    Vector3d slug = Vector3d::Zero();
    if (driven.slug_inertia > 0) slug = drag / driven.slug_inertia;
    if (driven.slug_inertia > 0 && driven.slug_turned) slug -= w.cross(s);
    Now out;
    out << 0.5 * (Quaterniond(x.head<4>()) * Quaterniond(0, w.x(), w.y(), w.z())).coeffs(),
        inverse * ((tensor * w).cross(w) + driven.torque(t, m) - drag), slug;
    return out;
  };
  return [=](double t) {
    while (*time < t) {
      double end = t;
      for (const double s : driven.switches) {
        if (s > *time) end = std::min(end, s);
      }
      const int steps = static_cast<int>(std::ceil((end - *time) / step));
      const double h = (end - *time) / steps;
      for (int i = 0; i < steps; ++i) {
        // The torque of a step is that inside it, because a torque may switch at its ends.
        const double a = *time + i * h, inside = 1e-9 * h;
        const Now k1 = rate(a + inside, *now), k2 = rate(a + 0.5 * h, *now + 0.5 * h * k1);
        const Now k3 = rate(a + 0.5 * h, *now + 0.5 * h * k2), k4 = rate(a + h - inside, *now + h * k3);
        *now += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        now->head<4>().normalize();
      }
      *time = end;
    }
    return momentOf(*now);
  };
}

Truth lieEuler(const Vector3d& moments, const Quaterniond& attitude, const Vector3d& omega_body, double step) {
  return [=](double t) {
    Quaterniond q = attitude;
    Vector3d p = moments.cwiseProduct(omega_body);
    const auto advance = [&](double h) {
      const Quaterniond d = turn(h * p.cwiseQuotient(moments));
      q = (q * d).normalized();
      p = d.conjugate() * p;
    };
    const int whole = static_cast<int>(std::floor(t / step));
    for (int i = 0; i < whole; ++i) advance(step);
    advance(t - whole * step);
    return Moment{q, p.cwiseQuotient(moments)};
  };
}

std::vector<Tick> steadily(int count, double start) {
  std::vector<Tick> ticks;
  const std::int64_t first = 1700000000123456789;
  for (int i = 0; i < count; ++i) {
    const std::int64_t after = std::llround(i * (1e9 / 60));
    ticks.push_back({first + after, start + 1e-9 * static_cast<double>(after), 1, 0});
  }
  return ticks;
}

Matrix3d BodySetup::tensor() const {
  const Matrix3d p = axes.toRotationMatrix();
  const Matrix3d m = p * moments.asDiagonal() * p.transpose();
  return 0.5 * (m + m.transpose());
}

bool Stream::driven() const {
  for (const std::string& effect : setup.effects) {
    if (effect.rfind("translation", 0) != 0) return true;
  }
  return false;
}

Stream::Stream(const BodySetup& s, const Truth& truth, const std::vector<Tick>& ticks) : setup(s) {
  const Matrix3d tensor = s.tensor();
  const std::string frame = s.prefix + s.body, space = frame + "_space", model = frame + "_model";
  const std::string turning = frame + "_space_body";

  description.body = s.body;
  for (int i = 0; i < 9; ++i) description.inertia_tensor[i] = tensor(i / 3, i % 3);
  for (int i = 0; i < 3; ++i) description.principal_moments[i] = s.moments[i];
  description.principal_axes = wxyz(s.axes);
  description.method = s.method;
  description.step = s.method == "closed_form" ? NAN : s.step;
  description.accuracy = NAN;
  description.effects = s.effects;
  description.metres_per_radian_per_second = s.scale;
  description.metres_per_angular_momentum = 1;

  tf_static.transforms.push_back(transform(ros::Time(), "world", space, {-3, 0, 0}, Quaterniond::Identity()));
  tf_static.transforms.push_back(transform(ros::Time(), "world", model, {3, 0, 0}, Quaterniond::Identity()));

  const Moment start = truth(0);
  const Vector3d l_start = tensor * start.omega_body;
  const double e_start = 0.5 * start.omega_body.dot(l_start);
  double e0 = 0;
  Vector3d l0 = Vector3d::Zero();
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const Tick& tick = ticks[i];
    const Moment now = truth(tick.time);
    const double t = tick.time;
    const ros::Time stamp = stampTime(tick.stamp);
    BodyState state;
    state.header.stamp = stamp;
    state.header.frame_id = "world";
    state.body = s.body;
    state.time = t;
    state.time_rate = tick.time_rate;
    state.segment = tick.segment;
    state.attitude = wxyz(now.attitude);
    const Vector3d position = s.velocity * t + 0.5 * t * t * s.acceleration, velocity = s.velocity + t * s.acceleration;
    const Vector3d body_l = tensor * now.omega_body;
    const Vector3d l = now.attitude * (body_l + s.slug_inertia * now.slug_omega),
                   omega_world = now.attitude * now.omega_body;
    const double e = 0.5 * now.omega_body.dot(tensor * now.omega_body);
    if (i == 0 || tick.segment != ticks[i - 1].segment) {
      e0 = e;
      l0 = l;
    }
    state.position = xyz<geometry_msgs::Point>(position);
    state.velocity = xyz<geometry_msgs::Vector3>(velocity);
    state.omega_body = xyz<geometry_msgs::Vector3>(now.omega_body);
    state.omega_world = xyz<geometry_msgs::Vector3>(omega_world);
    state.momentum_world = xyz<geometry_msgs::Vector3>(l);
    state.kinetic_energy = e;
    state.energy_drift = e0 > 0 ? (e - e0) / e0 : 0;
    state.momentum_drift = e0 > 0 ? (l - l0).norm() / l0.norm() : 0;
    state.attitude_error = driven() ? NAN : s.attitude_error;
    states.push_back(state);

    nav_msgs::Odometry odom;
    odom.header = state.header;
    odom.child_frame_id = frame;
    odom.pose.pose.position = state.position;
    odom.pose.pose.orientation = state.attitude;
    odom.twist.twist.linear = xyz<geometry_msgs::Vector3>(now.attitude.conjugate() * velocity);
    odom.twist.twist.angular = state.omega_body;
    odometry.push_back(odom);

    tf2_msgs::TFMessage frames;
    frames.transforms.push_back(transform(stamp, "world", frame, position, now.attitude));
    frames.transforms.push_back(transform(stamp, space, turning, Vector3d::Zero(), now.attitude));
    tf.push_back(frames);

    visualization_msgs::MarkerArray moving;
    Marker arrow = marker(s.body + "/space/omega", space, Marker::ARROW, stamp);
    arrow.points = {xyz<geometry_msgs::Point>(Vector3d::Zero()), xyz<geometry_msgs::Point>(s.scale * omega_world)};
    Marker point = marker(s.body + "/model/omega", model, Marker::SPHERE, stamp);
    point.pose.position = xyz<geometry_msgs::Point>(s.scale * now.omega_body);
    moving.markers = {arrow, point};
    for (const std::string picture : {"space", "model"}) {
      if (!driven()) continue;
      const std::string where = picture == "space" ? turning : model, ns = s.body + "/" + picture + "/";
      Marker energy = marker(ns + "energy_ellipsoid", where, Marker::SPHERE, stamp);
      energy.pose.orientation = wxyz(s.axes);
      energy.scale = xyz<geometry_msgs::Vector3>(2 * s.scale * (2 * e / s.moments.array()).sqrt());
      Marker momentum = marker(ns + "momentum_ellipsoid", where, Marker::SPHERE, stamp);
      momentum.pose.orientation = wxyz(s.axes);
      momentum.scale = xyz<geometry_msgs::Vector3>(2 * s.scale * body_l.norm() * s.moments.cwiseInverse());
      moving.markers.push_back(energy);
      moving.markers.push_back(momentum);
    }
    markers.push_back(moving);
  }

  if (driven()) return;
  // The polhode is where the true motion leads the point of the model picture.
  const Truth exact = anyBody(tensor, start.attitude, start.omega_body);
  std::vector<geometry_msgs::Point> polhode;
  for (int i = 0; i <= 200; ++i)
    polhode.push_back(xyz<geometry_msgs::Point>(1.01 * s.scale * exact(0.02 * i).omega_body));
  for (const std::string picture : {"space", "model"}) {
    const std::string where = picture == "space" ? turning : model, ns = s.body + "/" + picture + "/";
    Marker energy = marker(ns + "energy_ellipsoid", where, Marker::SPHERE);
    energy.pose.orientation = wxyz(s.axes);
    energy.scale = xyz<geometry_msgs::Vector3>(2 * s.scale * (2 * e_start / s.moments.array()).sqrt());
    Marker momentum = marker(ns + "momentum_ellipsoid", where, Marker::SPHERE);
    momentum.pose.orientation = wxyz(s.axes);
    momentum.scale = xyz<geometry_msgs::Vector3>(2 * s.scale * l_start.norm() * s.moments.cwiseInverse());
    Marker line = marker(ns + "polhode", where, Marker::LINE_STRIP);
    line.scale.x = 0.01;
    line.points = polhode;
    for (const Marker& m : {energy, momentum, line}) markers_static.markers.push_back(m);
  }
}

Marker& Stream::drawn(const std::string& what) {
  for (Marker& m : markers_static.markers) {
    if (m.ns == setup.body + "/" + what) return m;
  }
  throw std::invalid_argument(what);
}

void Stream::feed(audit::Audit& audit) const {
  const std::string ns = setup.ns == "/" ? "/" : setup.ns + "/";
  // In an order that no live stream has: topics may come in any.
  for (const auto& m : markers) audit.add(m, ns + "markers");
  for (const auto& m : states) audit.add(m, ns + setup.body + "/state");
  for (const auto& m : tf) audit.add(m, false);
  if (!tf_static.transforms.empty()) audit.add(tf_static, true);
  for (const auto& m : odometry) audit.add(m, ns + setup.body + "/odometry");
  if (!description.body.empty()) audit.add(description, ns + setup.body + "/description");
  if (!markers_static.markers.empty()) audit.add(markers_static, ns + "markers_static");
}

audit::Report Stream::judged(const audit::Options& options) const {
  audit::Audit audit(options);
  feed(audit);
  return audit.report();
}

}  // namespace poinsot::test
