#include "torque_rows.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <stdexcept>

#include "comparisons.h"

namespace poinsot {
namespace {

/** By commas that are not inside double quotes, which are left out. */
std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> out(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      out.emplace_back();
    } else if (c != '\r') {
      out.back() += c;
    }
  }
  return out;
}

using Cells = std::map<std::string, std::string>;

std::vector<Cells> table(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path);
  std::vector<std::string> names;
  std::vector<Cells> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    const std::vector<std::string> values = cells(line);
    if (names.empty()) {
      names = values;
      continue;
    }
    if (values.size() != names.size()) throw std::runtime_error("row of another length: " + line);
    Cells row;
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = values[i];
    rows.push_back(row);
  }
  return rows;
}

long double number(const Cells& row, const std::string& name) {
  const std::string& text = row.at(name);
  char* end = nullptr;
  const long double value = std::strtold(text.c_str(), &end);
  if (text.empty() || *end) throw std::runtime_error(row.at("id") + ": " + name + " is not a number");
  return value;
}

/** An input of torque.csv, which stands there twice. */
double input(const Cells& row, const std::string& name) {
  const auto value = static_cast<double>(number(row, name + "_hex"));
  if (value != std::strtod(row.at(name).c_str(), nullptr)) {
    throw std::runtime_error(row.at("id") + ": " + name + " contradicts itself");
  }
  return value;
}

std::string list(const std::vector<double>& values) {
  std::string out;
  for (const double value : values) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", value);
    out += (out.empty() ? "[" : ", ") + std::string(text);
  }
  return out + "]";
}

TorqueRow withTruth(const Cells& row, const std::string& body, double t) {
  return {row.at("id"),
          row.at("note"),
          body,
          t,
          {number(row, "qw"), number(row, "qx"), number(row, "qy"), number(row, "qz")},
          {number(row, "O1"), number(row, "O2"), number(row, "O3")},
          static_cast<double>(number(row, "cond_rad")),
          static_cast<double>(number(row, "cond_omega"))};
}

}  // namespace

double TorqueRow::attitudeError(const Eigen::Quaterniond& q) const {
  return angle(attitude, q.cast<long double>());
}

double TorqueRow::omegaError(const Eigen::Vector3d& w) const {
  const long double off = (w.cast<long double>() - omega).norm();
  return off == 0 ? 0 : static_cast<double>(off / omega.norm());
}

std::string TorqueRow::scene(const std::string& method) const {
  return "bodies: [{name: body, " + method + ", " + body + "}]\n";
}

std::vector<TorqueRow> readTorqueColumns(const std::string& path) {
  std::vector<TorqueRow> out;
  for (const Cells& row : table(path)) {
    const auto three = [&row](const std::string& name) {
      return std::vector<double>{input(row, name + "1"), input(row, name + "2"), input(row, name + "3")};
    };
    const auto zero = [](const std::vector<double>& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; };
    std::vector<std::string> effects;
    if (!zero(three("b"))) effects.push_back("{type: constant_torque, frame: body, torque: " + list(three("b")) + "}");
    if (!zero(three("w"))) effects.push_back("{type: constant_torque, frame: world, torque: " + list(three("w")) + "}");
    if (!zero(three("c"))) {
      effects.push_back("{type: gravity_torque, mass: 1, gravity: " + list(three("F")) +
                        ", centre_of_mass: " + list(three("c")) + "}");
    }
    if (const double d = input(row, "d"); d != 0) {
      effects.push_back("{type: viscous_damping, coefficient: " + list({d, d, d}) + "}");
    }
    if (effects.empty()) throw std::runtime_error(row.at("id") + " has no torque");
    std::string all;
    for (const std::string& effect : effects) all += (all.empty() ? "" : ", ") + effect;
    out.push_back(withTruth(row,
                            "inertia: " + list(three("mu")) + ", attitude: " +
                                list({input(row, "q0w"), input(row, "q0x"), input(row, "q0y"), input(row, "q0z")}) +
                                ", angular_velocity: " + list(three("O0")) + ", effects: [" + all + "]",
                            input(row, "t")));
  }
  return out;
}

std::vector<TorqueRow> readTorqueScenes(const std::string& path) {
  std::vector<TorqueRow> out;
  for (const Cells& row : table(path)) {
    const std::string& scene = row.at("scene");
    if (scene.size() < 2 || scene.front() != '{' || scene.back() != '}') {
      throw std::runtime_error(row.at("id") + ": the scene is not a map");
    }
    out.push_back(withTruth(row, scene.substr(1, scene.size() - 2), static_cast<double>(number(row, "t"))));
  }
  return out;
}

}  // namespace poinsot
