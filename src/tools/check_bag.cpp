// Audits a recorded bag from its messages alone.

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>

#include "poinsot/audit/audit.h"
#include "standard_output.h"

namespace {

using poinsot::audit::Audit;

/** Topics are known by their type, so that renamed ones count; tf alone by its name, as everywhere in ROS. */
void read(const std::string& file, Audit& audit) {
  rosbag::Bag bag(file, rosbag::bagmode::Read);
  for (const rosbag::MessageInstance& m : rosbag::View(bag)) {
    const std::string& topic = m.getTopic();
    if (const auto state = m.instantiate<poinsot::BodyState>()) {
      audit.add(*state, topic);
    } else if (const auto description = m.instantiate<poinsot::BodyDescription>()) {
      audit.add(*description, topic);
    } else if (const auto odometry = m.instantiate<nav_msgs::Odometry>()) {
      audit.add(*odometry, topic);
    } else if (const auto markers = m.instantiate<visualization_msgs::MarkerArray>()) {
      audit.add(*markers, topic);
    } else if (const auto tf = m.instantiate<tf2_msgs::TFMessage>()) {
      audit.add(*tf, topic == "/tf_static" || topic == "tf_static");
    }
  }
}

bool beginsAsBag(const std::string& file) {
  const std::string magic = "#ROSBAG V2.0\n";
  std::string begin(magic.size(), ' ');
  std::ifstream in(file, std::ios::binary);
  return in.read(&begin[0], static_cast<std::streamsize>(begin.size())) && begin == magic;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Audits a recorded bag of Poinsot from its messages alone: a line per check with its worst figure.\n"
      "Exit 0: all checks passed; 1: one failed; 2: bad use, unreadable bag, or nothing of Poinsot in it."};
  std::string file;
  poinsot::audit::Options options;
  std::vector<std::string> without;
  app.add_option("bag", file, "the bag file")->required();
  app.add_option("--without", without, "what the recording is not meant to carry: markers, odometry or tf")
      ->check(CLI::IsMember({"markers", "odometry", "tf"}))
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--drift", options.drift, "relative drift of E and L that is too much whatever the method allows")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  for (const std::string& what : without) {
    if (what == "markers") options.markers = false;
    if (what == "odometry") options.odometry = false;
    if (what == "tf") options.tf = false;
  }

  Audit audit(options);
  try {
    read(file, audit);
  } catch (const rosbag::BagException& error) {
    std::cerr << "check_bag: " << file << ": " << error.what() << "\n";
    if (beginsAsBag(file)) {
      std::cerr << "A recording that was cut off can be read after: rosbag reindex '" << file << "'\n";
    }
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "check_bag: " << file << ": " << error.what() << "\n";
    return 2;
  }
  if (audit.empty()) {
    std::cerr << "check_bag: " << file << ": no message of type poinsot/BodyState or poinsot/BodyDescription in it\n";
    return 2;
  }
  const poinsot::audit::Report report = audit.report();
  std::cout << report;
  try {
    poinsot::tools::flushStandardOutput();
  } catch (const std::runtime_error& error) {
    std::cerr << "check_bag: " << error.what() << "\n";
    return 2;
  }
  return report.passed() ? 0 : 1;
}
