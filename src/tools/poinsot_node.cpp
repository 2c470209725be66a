#include <ros/console.h>
#include <ros/init.h>
#include <ros/master.h>
#include <ros/node_handle.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include "poinsot/cost/cancelled.h"
#include "poinsot/cost/resolve_accuracy.h"
#include "poinsot/ros/interrupt.h"
#include "poinsot/ros/markers/meshes.h"
#include "poinsot/ros/node.h"
#include "poinsot/ros/scene_text.h"
#include "poinsot/scene/reader.h"
#include "standard_output.h"

namespace {

constexpr int kFailed = 1;
constexpr int kBadUse = 2;

constexpr std::chrono::milliseconds kBetweenLooks{100};

/** Waits for a ROS master, as a NodeHandle would, but can be interrupted: whether there is one. */
bool awaitMaster(const std::atomic<bool>& interrupted) {
  for (bool said = false; !ros::master::check(); said = true) {
    if (!said) ROS_ERROR("waiting for a ROS master at %s", ros::master::getURI().c_str());
    for (int i = 0; i < 10 && !interrupted; ++i) std::this_thread::sleep_for(kBetweenLooks);
    if (interrupted) return false;
  }
  return true;
}

int check(const std::string& file) {
  try {
    poinsot::scene::Scene scene = poinsot::scene::readFile(file);
    poinsot::node::requireMeshes(scene);
    for (const std::string& warning : scene.warnings) std::cerr << warning << "\n";
    const double rate = scene.rate.value_or(poinsot::scene::kDefaultRate);
    for (const std::string& choice : poinsot::cost::resolveAccuracies(scene, rate)) std::cout << choice << "\n";
    std::cout << poinsot::node::checkedText(scene);
    poinsot::tools::flushStandardOutput();
    return 0;
  } catch (const poinsot::scene::Error& error) {
    std::cerr << error.what() << "\n";
    return kBadUse;
  } catch (const std::exception& error) {
    std::cerr << "poinsot_node: " << error.what() << "\n";
    return kFailed;
  }
}

}  // namespace

int main(int argc, char** argv) {
  ros::V_string words;
  ros::removeROSArgs(argc, argv, words);
  std::vector<std::string> arguments(words.rbegin(), words.rend() - 1);  // CLI11 takes them back to front

  CLI::App app(
      "Moves the rigid bodies of a scene and publishes their motion. Parameters: ~scene or ~scene_file, ~rate, "
      "~method, ~step, ~publish_clock, ~frame_prefix.",
      "poinsot_node");
  std::string file;
  app.add_option("--check", file,
                 "only read and validate this scene file, and print what it has: exit 0 when it is good, 2 when not");
  try {
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kBadUse;
  }
  if (app.count("--check") > 0) return check(file);

  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // what the node says is to be read while it runs, also in a file
  const std::atomic<bool>& interrupted = poinsot::node::interruptFlag();
  ros::init(argc, argv, "poinsot", ros::init_options::NoSigintHandler);
  if (!awaitMaster(interrupted)) return 0;
  // Outside the try block: when the last handle goes, ROS shuts down, and its console prints no more.
  ros::NodeHandle handle, private_handle("~");
  int code = kBadUse;
  try {
    poinsot::node::Node node(poinsot::node::readParameters(private_handle), handle, private_handle, interrupted);
    code = kFailed;
    node.run();
  } catch (const poinsot::cost::Cancelled&) {
    return 0;  // as later on, when it runs
  } catch (const std::exception& error) {
    ROS_FATAL("%s", error.what());
    return code;
  }
  return 0;
}
