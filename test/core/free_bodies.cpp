#include "free_bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ostream>
#include <utility>

namespace poinsot {

std::string shown(double value) {
  char text[80];
  std::snprintf(text, sizeof text, "%.17g = %a", value, value);
  return text;
}

std::ostream& operator<<(std::ostream& out, const FreeBody& body) {
  const auto show = [&out](const char* name, std::initializer_list<double> values) {
    out << name;
    const char* between = " (";
    for (const double value : values) {
      out << between << shown(value);
      between = ", ";
    }
    out << ")\n";
  };
  show("moments", {body.moments[0], body.moments[1], body.moments[2]});
  show("attitude", {body.attitude.w(), body.attitude.x(), body.attitude.y(), body.attitude.z()});
  show("omega", {body.omega[0], body.omega[1], body.omega[2]});
  return out;
}

namespace draw {
namespace {

/** From 0 to most. RapidCheck begins with small ranges and lets them grow; here every case has the whole one. */
std::int64_t upTo(std::int64_t most) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::int64_t>(0, most + 1));
}

/** x·(1 + k ulp) for a few k, or for one of any size. */
double justAbove(double x) {
  const double k = integer(0, 1) == 0 ? integer(1, 5) : std::ldexp(1.0, integer(0, 40));
  return x + k * (std::nextafter(x, 2 * x) - x);
}

Eigen::Vector3d shuffled(const Eigen::Vector3d& v) {
  std::array<int, 3> order = {0, 1, 2};
  const int n = integer(0, 5);
  for (int i = 0; i < n; ++i) std::next_permutation(order.begin(), order.end());
  return {v[order[0]], v[order[1]], v[order[2]]};
}

/** The axes from that of least to that of greatest moment. */
std::array<int, 3> ascending(const Eigen::Vector3d& moments) {
  std::array<int, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int i, int j) { return moments[i] < moments[j]; });
  return order;
}

Eigen::Vector3d nearSeparatrix(const Eigen::Vector3d& moments) {
  const auto [low, middle, high] = ascending(moments);
  const double slope =
      std::sqrt(moments[low] / moments[high] * (moments[middle] - moments[low]) / (moments[high] - moments[middle]));
  if (!(slope > 0) || !std::isfinite(slope)) return direction();
  const double apart = sign() * powerOfTen(-17, -1);
  const double size = powerOfTen(-3, 0) / std::max(1.0, slope);
  Eigen::Vector3d omega;
  omega[low] = sign() * size;
  omega[middle] = integer(0, 4) == 0 ? 0 : uniform(-1, 1);
  omega[high] = sign() * size * slope * (1 + apart);
  return omega;
}

Eigen::Vector3d nearAnAxis() {
  const int axis = integer(0, 2);
  Eigen::Vector3d omega;
  for (int i = 0; i < 3; ++i) omega[i] = sign() * (i == axis ? 1 : powerOfTen(-140, -1));
  return omega;
}

Eigen::Vector3d withTinyComponents() {
  Eigen::Vector3d omega = direction();
  for (int i = 0; i < 3; ++i) omega[i] *= integer(0, 3) == 0 ? 0 : powerOfTen(-30, 0);
  return omega;
}

double unitOfTime(const FreeBody& body) {
  return std::ldexp(1.0, -std::ilogb(body.omega.stableNorm()));
}

}  // namespace

int integer(int low, int high) {
  return low + static_cast<int>(upTo(high - low));
}

double uniform(double low, double high) {
  return low + (high - low) * std::ldexp(static_cast<double>(upTo((std::int64_t{1} << 53) - 1)), -53);
}

double sign() {
  return integer(0, 1) == 0 ? 1 : -1;
}

double powerOfTen(double low, double high) {
  return std::pow(10.0, uniform(low, high));
}

Eigen::Quaterniond attitude() {
  Eigen::Vector4d q;
  do {
    for (int i = 0; i < 4; ++i) q[i] = std::ldexp(std::rint(std::ldexp(uniform(-1, 1), 40)), -40);
  } while (q.norm() < 0.1);
  return Eigen::Quaterniond(q);
}

Eigen::Vector3d direction() {
  Eigen::Vector3d v;
  do {
    v = Eigen::Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
  } while (v.norm() < 0.1);
  return v.normalized();
}

Eigen::Vector3d moments() {
  const double one = uniform(0.5, 1), other = one * powerOfTen(-2, 2);
  switch (integer(0, 7)) {
    case 0:
    case 1: {
      const Eigen::Vector3d width(uniform(0.1, 1), uniform(0.1, 1), uniform(0.1, 1));
      return {width[1] + width[2], width[2] + width[0], width[0] + width[1]};
    }
    case 2:
      return {powerOfTen(-6, 6), powerOfTen(-6, 6), powerOfTen(-6, 6)};
    case 3:
      return Eigen::Vector3d(integer(1, 40), integer(1, 40), integer(1, 40));
    case 4:
      return shuffled({one, justAbove(one), other});
    case 5:
      return shuffled({one, one, other});
    case 6:
      return shuffled({one, justAbove(one), justAbove(one)});
    default:
      return {one, one, one};
  }
}

FreeBody body() {
  FreeBody body;
  body.moments = moments();
  body.attitude = attitude();
  switch (integer(0, 5)) {
    case 0:
    case 1:
      body.omega = direction();
      break;
    case 2:
    case 3:
      body.omega = nearSeparatrix(body.moments);
      break;
    case 4:
      body.omega = nearAnAxis();
      break;
    default:
      body.omega = withTinyComponents();
  }
  if (body.omega.isZero(0)) body.omega = Eigen::Vector3d::UnitZ();
  return body;
}

FreeBody bodyOfAnySize() {
  FreeBody any = body();
  any.moments *= powerOfTen(-50, 50);
  any.omega *= powerOfTen(-100, 100);
  return any;
}

FreeBody movingBody() {
  for (;;) {
    const FreeBody candidate = body();
    if (candidate.closedForm().regime() == ClosedForm::Regime::general) return candidate;
  }
}

FreeBody bodyOnSeparatrix() {
  // |Ω₁| : |Ω₃| with integers, so that Ω₃²μ₃(μ₃ − μ₂) = Ω₁²μ₁(μ₂ − μ₁) holds without rounding. None has μ₂ = 2μ₁, where
  // the separatrix would stay where it is, to first order, when μ₁ changes.
  struct Exact {
    double moments[3], first, third;
  };
  const Exact exact = oneOf<Exact>({{{2, 5, 6}, 1, 1},
                                    {{3, 5, 6}, 1, 1},
                                    {{3, 4, 6}, 2, 1},
                                    {{1, 3, 6}, 3, 1},
                                    {{2, 12, 15}, 3, 2},
                                    {{10, 12, 15}, 3, 2},
                                    {{1, 4, 16}, 8, 1},
                                    {{9, 17, 18}, 1, 2},
                                    {{8, 13, 18}, 3, 2}});
  const double size = std::ldexp(integer(1, 1 << 20), -20), scale = std::ldexp(1.0, integer(-30, 30));
  const double middle = integer(0, 4) == 0 ? 0 : uniform(-1, 1);
  const Eigen::Vector3d moments(exact.moments[0], exact.moments[1], exact.moments[2]);
  const Eigen::Vector3d omega(sign() * size * exact.first, middle, sign() * size * exact.third);
  std::array<int, 3> order = {0, 1, 2};
  const int n = integer(0, 5);
  for (int i = 0; i < n; ++i) std::next_permutation(order.begin(), order.end());
  FreeBody body;
  body.attitude = attitude();
  for (int i = 0; i < 3; ++i) {
    body.moments[i] = scale * moments[order[i]];
    body.omega[i] = omega[order[i]];
  }
  return body;
}

double time(const FreeBody& body, double most) {
  return sign() * powerOfTen(-3, std::log10(most)) / body.omega.stableNorm();
}

double onGrid(const FreeBody& body, double t) {
  const double grain = std::ldexp(unitOfTime(body), -20);
  return std::rint(t / grain) * grain;
}

}  // namespace draw
}  // namespace poinsot
