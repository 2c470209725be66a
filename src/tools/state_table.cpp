#include "state_table.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "poinsot/core/number_text.h"
#include "poinsot/scene/motion_setup.h"

namespace poinsot::tools {
namespace {

constexpr std::int64_t kRowsAtOnce = 256;
constexpr int kDigits = 17;

/** As printf's %.17g, which takes four times as long. */
char* print(char* begin, char* end, double value) {
#ifdef __cpp_lib_to_chars
  return std::to_chars(begin, end, value, std::chars_format::general, kDigits).ptr;
#else
  return begin + std::snprintf(begin, end - begin, "%.*g", kDigits, value);
#endif
}

template <std::size_t n>
void appendNumbers(const double (&numbers)[n], std::string& out) {
  char text[n * 26];
  char* at = text;
  for (const double number : numbers) {
    *at++ = ',';
    at = print(at, text + sizeof text, number + 0.0);  // no "-0"
  }
  out.append(text, at);
}

/** The rows of one body. */
class Run {
 public:
  explicit Run(const scene::Body& body)
      : body_(body),
        motion_(scene::motionSetup(body)),
        start_(motion_.at(0).invariants()),
        judged_(isJudged(motion_)) {}

  /** Throws std::runtime_error where the body has no state. */
  MotionState at(double t) {
    try {
      MotionState state = motion_.at(t);
      if (judged_) worst_.add(t, motion_.attitudeError(state), energyDrift(state.invariants(), start_));
      return state;
    } catch (const std::runtime_error& error) {  // range_error, NoConvergence
      throw std::runtime_error("body " + body_.name + " under " + body_.method + " at t = " + numberText(t, kDigits) +
                               " s: " + error.what());
    }
  }

  void appendRow(double t, const MoreColumns& columns, std::string& out) {
    const MotionState s = at(t);
    out += body_.name;
    appendNumbers({s.time, s.attitude.w(), s.attitude.x(), s.attitude.y(), s.attitude.z(), s.omega_body.x(),
                   s.omega_body.y(), s.omega_body.z(), s.position.x(), s.position.y(), s.position.z()},
                  out);
    if (columns.energy) {
      appendNumbers({s.kinetic_energy, s.momentum_world.x(), s.momentum_world.y(), s.momentum_world.z()}, out);
    }
    if (columns.errors) appendNumbers({motion_.attitudeError(s), energyDrift(s.invariants(), start_)}, out);
    out += '\n';
  }

  void appendWorst(std::vector<std::string>& out) const {
    if (judged_) out.push_back(worstErrorsText(body_.name, motion_, worst_));
  }

 private:
  const scene::Body& body_;
  Motion motion_;
  Invariants start_;
  bool judged_;
  WorstErrors worst_;
};

}  // namespace

bool isJudged(const Motion& motion) {
  return !motion.inClosedForm() && motion.closedForm();
}

std::string worstErrorsText(const std::string& body, const Motion& motion, const WorstErrors& worst) {
  char step[32];
  std::snprintf(step, sizeof step, "%.9g", *motion.setup().step);
  return "body " + body + ": " + motion.setup().method + " with a step of " + step + " s: " + worst.text();
}

std::vector<std::string> writeStateTable(const scene::Scene& scene, const SampleTimes& times,
                                         const MoreColumns& columns, TextSink& out,
                                         const std::function<void(std::int64_t)>& done) {
  const auto count = static_cast<std::int64_t>(times.count());
  out.text() += "body,t,qw,qx,qy,qz,O1,O2,O3,bx,by,bz" + headerOf(columns) + "\n";
  std::vector<std::string> worst;
  for (const scene::Body& body : scene.bodies) {
    Run run(body);
    for (std::int64_t k = 0; k < count;) {
      const std::int64_t end = std::min(count, k + kRowsAtOnce), rows = end - k;
      for (; k < end; ++k) run.appendRow(times.at(k), columns, out.text());
      out.pour();
      done(rows);
    }
    run.appendWorst(worst);
  }
  out.flush();
  return worst;
}

}  // namespace poinsot::tools
