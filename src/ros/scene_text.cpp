#include "poinsot/ros/scene_text.h"

#include <algorithm>

#include "poinsot/core/motion.h"
#include "poinsot/core/number_text.h"
#include "poinsot/ros/session_text.h"
#include "poinsot/scene/motion_setup.h"
#include "poinsot/session/body.h"

namespace poinsot::node {
namespace {

constexpr std::size_t kMostNamed = 20;  // bodies

std::size_t named(const scene::Scene& scene) {
  return std::min(scene.bodies.size(), kMostNamed);
}

/** Returns "and 80 more", after the separator, where not all bodies are named. */
std::string andMore(const scene::Scene& scene, const std::string& separator) {
  const std::size_t left = scene.bodies.size() - named(scene);
  return left == 0 ? "" : separator + "and " + std::to_string(left) + " more";
}

std::string methodText(const scene::Body& body) {
  return body.method + (body.step ? " with a step of " + numberText(*body.step, 6) + " s" : "");
}

std::string regimeOfStart(const scene::Body& body) {
  session::BodyStatus status;
  status.free = session::freeMotion(Motion(scene::motionSetup(body)), session::regimeOf(body), 0, 1);
  return regimeText(status);
}

}  // namespace

std::string playedText(const scene::Scene& scene, const Stage& stage) {
  std::string out = "playing " + stage.scene + " at " + numberText(stage.rate) + " Hz in namespace " + stage.name_space;
  if (!stage.frame_prefix.empty()) out += ", frames with the prefix " + stage.frame_prefix;
  for (std::size_t i = 0; i < named(scene); ++i) {
    out += (i == 0 ? ": " : "; ") + scene.bodies[i].name + " by " + methodText(scene.bodies[i]);
  }
  return out + andMore(scene, "; ");
}

std::string checkedText(const scene::Scene& scene) {
  std::string out;
  for (std::size_t i = 0; i < named(scene); ++i) {
    const scene::Body& body = scene.bodies[i];
    out += body.name + ": " + methodText(body) + ", " + regimeOfStart(body) + "\n";
  }
  out += andMore(scene, "") + (scene.bodies.size() > named(scene) ? "\n" : "") + "no fault";
  const std::size_t warnings = scene.warnings.size();
  return out + (warnings == 0   ? "\n"
                : warnings == 1 ? ", one warning\n"
                                : ", " + std::to_string(warnings) + " warnings\n");
}

}  // namespace poinsot::node
