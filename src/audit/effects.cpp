#include "poinsot/audit/effects.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>

#include "poinsot/audit/report.h"

namespace poinsot::audit {
namespace {

using Eigen::Vector3d;

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument(why);
}

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

/** Returns the parts between separators, leaving out separators in brackets. */
std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char c : text) {
    depth += (c == '[') - (c == ']');
    if (c == separator && depth == 0) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  for (std::string& part : parts) part = trimmed(part);
  return parts;
}

double numberOf(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value)) refuse("expected a finite number, got \"" + text + "\"");
  return value;
}

Vector3d vectorFrom(const std::string& text) {
  const bool in_brackets = text.size() >= 2 && text.front() == '[' && text.back() == ']';
  const std::vector<std::string> parts = split(in_brackets ? text.substr(1, text.size() - 2) : "", ',');
  if (parts.size() != 3) refuse("expected [x, y, z], got \"" + text + "\"");
  return {numberOf(parts[0]), numberOf(parts[1]), numberOf(parts[2])};
}

/** The values of "key value, key value". Each read takes one away; done() refuses a key that is left. */
class Values {
 public:
  explicit Values(const std::string& text) {
    for (const std::string& item : split(text, ',')) {
      const auto space = item.find(' ');
      if (space == std::string::npos) refuse("expected a key and a value, got \"" + item + "\"");
      const std::string key = item.substr(0, space);
      if (!items_.emplace(key, trimmed(item.substr(space))).second) refuse("key \"" + key + "\" is given twice");
    }
  }

  std::string word(const std::string& key) {
    const auto item = items_.extract(key);
    if (item.empty()) refuse("key \"" + key + "\" is missing");
    return item.mapped();
  }
  double number(const std::string& key) { return numberOf(word(key)); }
  Vector3d vector(const std::string& key) { return vectorFrom(word(key)); }
  double positive(const std::string& key) {
    const double value = number(key);
    if (!(value > 0)) refuse(key + text(": expected a positive number, got %g", value));
    return value;
  }
  Vector3d direction(const std::string& key) {
    const Vector3d v = vector(key);
    if (!(v.stableNorm() > 0)) refuse(key + ": expected a vector other than 0");
    return v.stableNormalized();
  }
  bool frameIsWorld() {
    const std::string frame = word("frame");
    if (frame != "world" && frame != "body") refuse("frame: expected body or world, got \"" + frame + "\"");
    return frame == "world";
  }
  void done() const {
    if (!items_.empty()) refuse("unknown key \"" + items_.begin()->first + "\"");
  }

 private:
  std::map<std::string, std::string> items_;
};

void readPush(Values& values, bool scheduled, Effects& out) {
  Effects::Push push;
  if (scheduled) {
    push.from = values.number("from");
    push.to = values.number("to");
    if (!(push.from < push.to)) refuse(text("to: expected a time after from (%g s), got %g s", push.from, push.to));
  }
  push.world = values.frameIsWorld();
  push.torque = values.vector("torque");
  out.pushes.push_back(push);
}

void readOne(const std::string& effect, Effects& out) {
  const auto colon = effect.find(':');
  if (colon == std::string::npos) refuse("expected \"type: \" at the start");
  const std::string type = effect.substr(0, colon), rest = effect.substr(colon + 1);
  if (type == "torque_schedule") {
    for (const std::string& segment : split(rest, ';')) {
      Values values(segment);
      readPush(values, true, out);
      values.done();
    }
    return;
  }
  Values values(rest);
  if (type == "constant_torque") {
    readPush(values, false, out);
  } else if (type == "gravity_torque") {
    out.weights.push_back({values.positive("mass"), values.vector("gravity"), values.vector("centre_of_mass")});
  } else if (type == "gravity_gradient") {
    Effects::Orbit orbit{values.positive("orbit_rate"), values.direction("orbit_normal"),
                         values.direction("radial_at_start")};
    if (std::abs(orbit.normal.dot(orbit.radial)) > 1e-9)
      refuse("orbit_normal and radial_at_start are not perpendicular");
    orbit.radial = (orbit.radial - orbit.normal.dot(orbit.radial) * orbit.normal).normalized();
    out.orbits.push_back(orbit);
  } else if (type == "viscous_damping") {
    const std::string value = values.word("coefficient");
    const bool each = !value.empty() && value.front() == '[';
    const Vector3d damping = each ? vectorFrom(value) : Vector3d::Constant(numberOf(value));
    if (damping.minCoeff() < 0) refuse(text("coefficient: expected at least 0, got %g", damping.minCoeff()));
    out.dampings.push_back(damping);
  } else if (type == "internal_dissipation") {
    if (out.slug) refuse("expected at most one internal_dissipation, got a second");
    out.slug = Effects::Slug{values.positive("slug_inertia"), values.number("damping")};
    if (out.slug->damping < 0) refuse(text("damping: expected at least 0, got %g", out.slug->damping));
  } else if (type == "translation") {
    if (out.translation) refuse("expected at most one translation, got a second");
    out.translation =
        Effects::Translation{values.vector("position"), values.vector("velocity"), values.vector("acceleration")};
  } else {
    refuse("unknown type \"" + type + "\"");
  }
  values.done();
}

}  // namespace

Vector3d Effects::Orbit::radialAt(double t) const {
  return std::cos(rate * t) * radial + std::sin(rate * t) * normal.cross(radial);
}

bool Effects::momentumIsKnown() const {
  return weights.empty() && orbits.empty() && dampings.empty() &&
         std::all_of(pushes.begin(), pushes.end(), [](const Push& p) { return p.world; });
}

Vector3d Effects::impulse(double from, double to) const {
  Vector3d sum = Vector3d::Zero();
  const double begin = std::min(from, to), end = std::max(from, to);
  for (const Push& p : pushes) sum += std::max(0.0, std::min(end, p.to) - std::max(begin, p.from)) * p.torque;
  return from <= to ? sum : Vector3d(-sum);
}

Effects readEffects(const std::vector<std::string>& texts) {
  Effects out;
  for (const std::string& text : texts) {
    const bool is_torque = text.substr(0, text.find(':')) != "translation";
    out.turns = out.turns || is_torque;
    try {
      readOne(text, out);
    } catch (const std::invalid_argument& why) {
      if (out.problem.empty()) out.problem = "\"" + text + "\" cannot be read: " + why.what();
      (is_torque ? out.torques_are_read : out.translation_is_read) = false;
    }
  }
  return out;
}

}  // namespace poinsot::audit
