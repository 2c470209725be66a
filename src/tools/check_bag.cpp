// Audits a recorded bag from its messages alone.

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "command_line.h"
#include "poinsot/audit/audit.h"
#include "standard_output.h"

namespace {

using poinsot::audit::Audit;

/** Reads the bag. Topics are recognised by their type, so that they may be renamed; tf alone by its name. */
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
    } else if (const auto layout = m.instantiate<poinsot::SceneLayout>()) {
      audit.add(*layout);
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

/** Throws std::runtime_error, with the name of the file, where it cannot be read. */
void readOrExplain(const std::string& file, Audit& audit) {
  try {
    read(file, audit);
  } catch (const std::exception& error) {
    const bool was_cut_off = dynamic_cast<const rosbag::BagException*>(&error) && beginsAsBag(file);
    throw std::runtime_error(
        file + ": " + error.what() +
        (was_cut_off ? "; a recording that was cut off can be read after: rosbag reindex '" + file + "'" : ""));
  }
}

}  // namespace

int main(int argc, char** argv) {
  namespace tools = poinsot::tools;
  CLI::App app(
      "Audits a recorded bag of Poinsot from its messages alone: a line per check with its worst figure.\n"
      "Exit 0: all checks passed; 1: one failed; 2: bad use, unreadable bag, or nothing of Poinsot in it.",
      "check_bag");
  std::string file;
  poinsot::audit::Options options;
  std::vector<std::string> without;
  std::optional<double> drift = options.drift;
  app.add_option("bag", file, "the bag file")->required();
  app.add_option("--without", without, "what the recording is not meant to carry: markers, odometry or tf")
      ->check(tools::oneOf({"markers", "odometry", "tf"}))
      ->delimiter(',')
      ->allow_extra_args(false);
  tools::addPositive(app, "--drift", drift, "",
                     "relative drift of E and L that is too much whatever the method allows");
  if (const auto code = tools::parse(app, argc, argv)) return *code;
  options.drift = *drift;
  for (const std::string& what : without) {
    if (what == "markers") options.markers = false;
    if (what == "odometry") options.odometry = false;
    if (what == "tf") options.tf = false;
  }

  Audit audit(options);
  std::optional<poinsot::audit::Report> report;
  const int code = tools::exitCodeOf("check_bag", tools::kBadUse, tools::kBadUse, [&] {
    readOrExplain(file, audit);
    if (audit.empty()) {
      throw std::runtime_error(file +
                               ": expected messages of type poinsot/BodyState or poinsot/BodyDescription, got none");
    }
    report = audit.report();
    std::cout << *report;
    tools::flushStandardOutput();
  });
  return code != 0 || report->passed() ? code : 1;
}
