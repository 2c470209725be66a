#include "poinsot/cost/method_costs.h"

#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "poinsot/core/motion.h"
#include "poinsot/core/stepper.h"
#include "poinsot/cost/cpu_time.h"
#include "poinsot/cost/torque_choice.h"
#include "poinsot/scene/reader.h"

namespace poinsot::cost {
namespace {

constexpr int kStates = 1000;     // to one measurement
constexpr int kRepetitions = 12;  // the fastest counts: whatever disturbs makes it slower
constexpr double kStep = 0.01;    // s

/** Seconds per call of `use(i)`, i = 0 … count − 1, on a fresh copy of the motion each time. */
template <class Use>
double fastest(const Motion& start, int count, Use use) {
  double best = 1e9;
  for (int r = 0; r < kRepetitions; ++r) {
    Motion motion = start;
    const double begin = threadCpuTime();
    for (int i = 0; i < count; ++i) use(motion, i);
    best = std::min(best, (threadCpuTime() - begin) / count);
  }
  return best;
}

/** A free body, or a heavy top. */
MethodCost measure(const std::string& method, const std::vector<Effect>& effects = {}) {
  MotionSetup setup;
  setup.inertia = PrincipalInertia::fromMoments({1, 2, 3});
  setup.omega_body = {0.6, 0.5, 0.7};
  setup.method = method;
  setup.effects = effects;
  if (method != kClosedForm) setup.step = kStep;
  const Motion start(setup);
  [[maybe_unused]] volatile double sink = 0;
  // A whole step, and then a partial one, to each state.
  const double state =
      fastest(start, kStates, [&](Motion& motion, int i) { sink = motion.at((i + 0.5) * kStep).attitude.w(); });
  if (method == kClosedForm) return {state, 0};
  const double step = fastest(start, 1, [&](Motion& motion, int) { sink = motion.at(kStates * kStep).attitude.w(); });
  const double per_step = step / kStates;
  return {std::max(state - per_step, 0.0), per_step};
}

/** What the figures hold for. */
std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  const std::string key = "model name";
  for (std::string line; std::getline(in, line);) {
    if (line.compare(0, key.size(), key) != 0) continue;
    const std::size_t colon = line.find(':');
    if (colon != std::string::npos && colon + 2 <= line.size()) return line.substr(colon + 2);
  }
  return "unknown";
}

std::map<std::string, MethodCost> cached(const std::string& file) {
  std::map<std::string, MethodCost> costs;
  try {
    const YAML::Node tree = scene::readDocument(file);
    if (tree["processor"].as<std::string>() != processor()) return {};
    if (tree["version"].as<std::string>() != POINSOT_VERSION) return {};
    for (const auto& entry : tree["methods"]) {
      const MethodCost cost{entry.second["per_state"].as<double>(), entry.second["per_step"].as<double>()};
      const bool sane = cost.per_state >= 0 && cost.per_state < 1 && cost.per_step >= 0 && cost.per_step < 1;
      if (!sane) return {};
      costs[entry.first.as<std::string>()] = cost;
    }
  } catch (const scene::Error&) {
    return {};
  } catch (const YAML::Exception&) {
    return {};
  }
  for (const Method& method : methods()) {
    if (!costs.count(method.name)) return {};
  }
  for (const TorqueMethod& method : torqueMethods()) {
    if (!costs.count(torqueCostName(method.name))) return {};
  }
  return costs.count(kClosedForm) ? costs : std::map<std::string, MethodCost>();
}

/** All of it or nothing: another process may read at any time. */
void write(const std::string& file, const std::map<std::string, MethodCost>& costs) {
  YAML::Emitter out;
  out.SetDoublePrecision(4);
  out << YAML::Comment("CPU time of Poinsot's methods on this machine [s]; measured again when this file is removed.");
  out << YAML::BeginMap << YAML::Key << "processor" << YAML::Value << processor();
  out << YAML::Key << "version" << YAML::Value << POINSOT_VERSION;
  out << YAML::Key << "methods" << YAML::Value << YAML::BeginMap;
  for (const auto& [name, cost] : costs) {
    out << YAML::Key << name << YAML::Value << YAML::Flow << YAML::BeginMap;
    out << YAML::Key << "per_state" << YAML::Value << cost.per_state;
    out << YAML::Key << "per_step" << YAML::Value << cost.per_step << YAML::EndMap;
  }
  out << YAML::EndMap << YAML::EndMap;

  std::error_code error;
  const std::filesystem::path path(file);
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  const std::string temporary = file + "." + std::to_string(getpid());
  {
    std::ofstream stream(temporary);
    stream << out.c_str() << "\n";
    if (!stream.flush()) {
      std::filesystem::remove(temporary, error);
      return;
    }
  }
  std::filesystem::rename(temporary, path, error);
  if (error) std::filesystem::remove(temporary, error);
}

}  // namespace

double MethodCosts::perSimulatedSecond(const std::string& method, double step, double rate) const {
  const MethodCost& cost = of(method);
  return rate * cost.per_state + (method == kClosedForm ? 0 : cost.per_step / step);
}

MethodCosts measureCosts() {
  std::map<std::string, MethodCost> costs = {{kClosedForm, measure(kClosedForm)}};
  for (const Method& method : methods()) costs[method.name] = measure(method.name);
  const GravityTorque weight{1, {0, 0, -1}, {0.1, -0.1, 0.3}};
  for (const TorqueMethod& method : torqueMethods())
    costs[torqueCostName(method.name)] = measure(method.name, {weight});
  return MethodCosts(costs);
}

std::string defaultCostFile() {
  if (const char* file = std::getenv("POINSOT_COSTS"); file && *file) return file;
  if (const char* home = std::getenv("ROS_HOME"); home && *home) return std::string(home) + "/poinsot/costs.yaml";
  if (const char* home = std::getenv("HOME"); home && *home) return std::string(home) + "/.ros/poinsot/costs.yaml";
  return "/tmp/poinsot_costs.yaml";
}

MethodCosts costsOfThisMachine(const std::string& file, bool measure_again) {
  if (!measure_again) {
    const std::map<std::string, MethodCost> costs = cached(file);
    if (!costs.empty()) return MethodCosts(costs);
  }
  const MethodCosts costs = measureCosts();
  write(file, costs.all());
  return costs;
}

}  // namespace poinsot::cost
