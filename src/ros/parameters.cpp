#include "poinsot/ros/parameters.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <sstream>

#include "poinsot/core/number_text.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/ros/markers/meshes.h"
#include "poinsot/ros/names.h"
#include "poinsot/ros/scene_list.h"
#include "poinsot/scene/changes.h"
#include "poinsot/scene/message.h"
#include "poinsot/scene/reader.h"

namespace poinsot::node {
namespace {

// What ROS's clocks and durations can pace.
constexpr double kSlowestRate = 1e-3;  // Hz
constexpr double kFastestRate = 1e4;   // Hz

/** Calls `use` with the value of a parameter that is set. */
template <class Use>
void ifSet(const ros::NodeHandle& handle, const char* name, Use use) {
  XmlRpc::XmlRpcValue value;
  if (handle.getParam(name, value)) use(value);
}

std::string placeOf(const char* name) {
  return std::string("parameter ~") + name;
}

[[noreturn]] void refuse(const char* name, const XmlRpc::XmlRpcValue& value, const std::string& expected) {
  std::ostringstream message;
  message << placeOf(name) << ": expected " << expected << ", got ";
  value.write(message);
  throw ParameterError(message.str());
}

/** Returns a number, read as in a scene file by `read`: readers of parameter files take `1e2` for a text. */
template <class Read>
double readNumber(const char* name, XmlRpc::XmlRpcValue& value, Read read) {
  const bool text = value.getType() == XmlRpc::XmlRpcValue::TypeString;
  return read(text ? YAML::Node(static_cast<std::string>(value)) : toYaml(value, placeOf(name)), placeOf(name));
}

std::string readText(const char* name, XmlRpc::XmlRpcValue& value, const std::string& expected) {
  if (value.getType() != XmlRpc::XmlRpcValue::TypeString) refuse(name, value, expected);
  return static_cast<std::string>(value);
}

std::string readPrefix(XmlRpc::XmlRpcValue& value) {
  const std::string expected = "an empty text, or one of letters, digits, _ and / that begins with a letter";
  const std::string prefix = readText(names::kFramePrefix, value, expected);
  const bool good = std::all_of(prefix.begin(), prefix.end(),
                                [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '/'; });
  if (!good || (!prefix.empty() && !std::isalpha(static_cast<unsigned char>(prefix[0])))) {
    refuse(names::kFramePrefix, value, expected);
  }
  return prefix;
}

/** Moves all bodies of the scene by `~method` and `~step`, where they are set. */
void applyMethod(const ros::NodeHandle& handle, scene::Scene& scene) {
  std::string method;
  ifSet(handle, names::kMethod,
        [&](XmlRpc::XmlRpcValue& value) { method = readText(names::kMethod, value, "the name of a method"); });
  std::optional<double> step;
  ifSet(handle, names::kMethodStep,
        [&](XmlRpc::XmlRpcValue& value) { step = readNumber(names::kMethodStep, value, scene::readStep); });
  if (step && (method.empty() || method == kClosedForm)) {
    throw ParameterError(
        placeOf(names::kMethodStep) + ": " +
        scene::expectedGot("no step, or one beside a ~method that steps",
                           numberText(*step, 15) + (method.empty() ? " without a ~method" : " beside " + method)));
  }
  if (method.empty()) return;
  for (scene::Body& body : scene.bodies) {
    const std::vector<std::string> known = scene::methodsFor(body);
    const bool moves = std::find(known.begin(), known.end(), method) != known.end();
    try {
      body = scene::withMethod(body, method, step, scene.warnings);
    } catch (const scene::Error& error) {
      throw ParameterError(placeOf(moves && step ? names::kMethodStep : names::kMethod) + ": " + error.what());
    }
  }
}

}  // namespace

Parameters readParameters(const ros::NodeHandle& handle) {
  Parameters out;
  const bool has_tree = handle.hasParam(names::kScene);
  const bool has_file = handle.hasParam(names::kSceneFile);
  const std::string& here = handle.getNamespace();
  if (has_tree == has_file) {
    throw ParameterError(here + ": expected either ~scene (the tree of a scene file) or ~scene_file (its path), got " +
                         (has_tree ? "both" : "neither"));
  }
  ifSet(handle, names::kScene, [&](XmlRpc::XmlRpcValue& value) {
    const std::string source = "parameter " + here + "/" + names::kScene;
    try {
      out.scene = scene::readTree(toYaml(value, source), source);
    } catch (const std::invalid_argument& error) {
      throw ParameterError(error.what());
    }
  });
  ifSet(handle, names::kSceneFile, [&](XmlRpc::XmlRpcValue& value) {
    out.scene_file = readText(names::kSceneFile, value, "the path of a scene file");
    requireKnownScene(out.scene_file);
    out.scene = scene::readFile(out.scene_file);
  });

  requireMeshes(out.scene);
  applyMethod(handle, out.scene);
  if (out.scene.rate) out.rate = *out.scene.rate;
  ifSet(handle, names::kRate,
        [&](XmlRpc::XmlRpcValue& value) { out.rate = readNumber(names::kRate, value, scene::readRate); });
  if (out.rate < kSlowestRate || out.rate > kFastestRate) {
    const std::string place = handle.hasParam(names::kRate) ? placeOf(names::kRate) : "rate of the scene";
    throw ParameterError(place + ": expected a number from " + numberText(kSlowestRate) + " to " +
                         numberText(kFastestRate) + " (Hz), got " + numberText(out.rate));
  }
  ifSet(handle, names::kPublishClock, [&](XmlRpc::XmlRpcValue& value) {
    if (value.getType() != XmlRpc::XmlRpcValue::TypeBoolean) refuse(names::kPublishClock, value, "true or false");
    out.publish_clock = static_cast<bool>(value);
  });
  ifSet(handle, names::kFramePrefix, [&](XmlRpc::XmlRpcValue& value) {
    out.frame_prefix = readPrefix(value);
    checkPrefix(out.frame_prefix, out.scene);
  });
  return out;
}

void checkPrefix(const std::string& frame_prefix, const scene::Scene& scene) {
  for (const scene::Body& body : scene.bodies) {
    if (frame_prefix + body.name == names::kWorld) {
      refuse(names::kFramePrefix, XmlRpc::XmlRpcValue(frame_prefix), "a prefix that makes no body's frame \"world\"");
    }
  }
}

}  // namespace poinsot::node
