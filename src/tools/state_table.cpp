#include "state_table.h"

#include <charconv>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "poinsot/core/motion.h"
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

std::string shown(double value) {
  char text[32];
  return std::string(text, print(text, text + sizeof text, value));
}

void appendRow(const std::string& name, const MotionState& s, std::string& out) {
  const double numbers[] = {s.time,         s.attitude.w(),   s.attitude.x(),   s.attitude.y(),
                            s.attitude.z(), s.omega_body.x(), s.omega_body.y(), s.omega_body.z(),
                            s.position.x(), s.position.y(),   s.position.z()};
  char text[11 * 26];
  char* at = text;
  for (const double number : numbers) {
    *at++ = ',';
    at = print(at, text + sizeof text, number + 0.0);  // no "-0"
  }
  *at++ = '\n';
  out += name;
  out.append(text, at);
}

}  // namespace

void writeStateTable(const scene::Scene& scene, const SampleTimes& times, TextSink& out,
                     const std::function<void(std::int64_t)>& done) {
  const auto count = static_cast<std::int64_t>(times.count());
  out.text() += "body,t,qw,qx,qy,qz,O1,O2,O3,bx,by,bz\n";
  for (const scene::Body& body : scene.bodies) {
    Motion motion(scene::motionSetup(body));
    for (std::int64_t k = 0; k < count;) {
      const std::int64_t end = std::min(count, k + kRowsAtOnce), rows = end - k;
      for (; k < end; ++k) {
        try {
          appendRow(body.name, motion.at(times.at(k)), out.text());
        } catch (const std::runtime_error& error) {  // range_error, NoConvergence
          throw std::runtime_error("body " + body.name + " under " + body.method + " at t = " + shown(times.at(k)) +
                                   " s: " + error.what());
        }
      }
      out.pour();
      done(rows);
    }
  }
  out.flush();
}

}  // namespace poinsot::tools
