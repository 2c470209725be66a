// A scene file → its motion as CSV, as a bag, or both, without a ROS master.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "command_line.h"
#include "more_columns.h"
#include "output_file.h"
#include "poinsot/core/motion.h"
#include "poinsot/core/number_text.h"
#include "poinsot/cost/resolve_accuracy.h"
#include "poinsot/ros/scene_bag.h"
#include "poinsot/scene/motion_setup.h"
#include "poinsot/scene/reader.h"
#include "progress.h"
#include "sample_times.h"
#include "state_table.h"

namespace {

using namespace poinsot;
using tools::BadUse;
using tools::OutputError;
using tools::OutputFile;

constexpr int kFailed = 1;
constexpr double kMostRows = 1e12;   // of all bodies together: a disk of 200 TB
constexpr double kMostSteps = 1e12;  // of one body: hours
constexpr double kFastestBag = 1e6;  // Hz: stamps are whole nanoseconds
constexpr std::size_t kMostSaid = 20;
const char* const kStandardOutput = "-";
const char* const kPlainColumns = "states";

const char* const kAbout =
    "Simulates a scene, faster than real time and without a ROS master, into CSV, a bag, or both.\n\n"
    "CSV: body,t,qw,qx,qy,qz,O1,O2,O3,bx,by,bz with 17 significant digits, body after body: attitude body -> world, "
    "angular\n"
    "velocity in body axes [rad/s], position in world axes [m], at t = 0, 1/rate, 2/rate, ... and exactly the "
    "duration. For a free body that a stepper moves, a line on stderr gives the worst errors of the run.\n"
    "Bag: the node's messages on the node's topics, with stamps from 1 s on; replay.launch shows it, check_bag audits "
    "it.\n"
    "The same scene gives the same bytes, every time.\n\n"
    "A file comes whole or not at all: until it is complete, what was there before stays.\n"
    "Exit status: 0; 1 when a state cannot be computed or a file not be written; 2 for bad use or a bad scene.";

struct Options {
  std::string scene, csv, bag, columns = kPlainColumns;
  std::optional<double> duration, rate;
  bool no_markers = false;
};

void checkFiles(const Options& options) {
  if (options.csv.empty() && options.bag.empty()) {
    throw BadUse("output", "--csv FILE, --bag FILE, or both", "none");
  }
  if (options.bag == kStandardOutput) {
    throw BadUse("--bag", "a file", "-: a bag needs a file, and only --csv goes to standard output");
  }
  if (!options.csv.empty() && !options.bag.empty())
    tools::refuseSameFile("--bag", options.bag, "that of --csv", options.csv);
  if (!options.csv.empty()) tools::refuseSameFile("--csv", options.csv, "the scene", options.scene);
  if (!options.bag.empty()) tools::refuseSameFile("--bag", options.bag, "the scene", options.scene);
  if (options.csv.empty() && options.columns != kPlainColumns) {
    throw BadUse("--columns", "--csv beside it", "none");
  }
}

/** Refuses runs that would never end, and times that a bag cannot hold. */
void checkSize(const Options& options, const scene::Scene& scene, double duration, double rate,
               const tools::SampleTimes& times) {
  const double rows = times.count() * static_cast<double>(scene.bodies.size());
  if (!(rows <= kMostRows)) {
    throw BadUse("--duration", "at most " + numberText(kMostRows, 9) + " states",
                 numberText(rows, 9) + " (" + numberText(duration, 9) + " s at " + numberText(rate, 9) + " Hz)");
  }
  if (!options.bag.empty() && duration > node::SceneBag::kLatest) {
    throw BadUse("--duration", "at most " + numberText(node::SceneBag::kLatest, 9) + " s with --bag, which stamps hold",
                 numberText(duration, 9) + " s");
  }
  if (!options.bag.empty() && rate > kFastestBag) {
    throw BadUse("--rate", "at most " + numberText(kFastestBag, 9) + " Hz with --bag, which stamps tell apart",
                 numberText(rate, 9) + " Hz");
  }
  for (const scene::Body& body : scene.bodies) {
    if (!body.step || duration / *body.step <= kMostSteps) continue;
    throw BadUse("--duration",
                 "at most " + numberText(kMostSteps, 9) + " steps of body " + body.name + " under " + body.method,
                 numberText(duration / *body.step, 9) + " (" + numberText(duration, 9) + " s in steps of " +
                     numberText(*body.step, 9) + " s)");
  }
}

/** Returns a sentence on the worst errors of each free body that a stepper moves. */
std::vector<std::string> writeBag(const OutputFile& file, const scene::Scene& scene, const tools::SampleTimes& times,
                                  bool markers, tools::Progress& progress) {
  std::vector<tools::WorstErrors> worst(scene.bodies.size());
  std::vector<std::string> out;
  errno = 0;
  try {
    node::SceneBag bag(file.writePath(), scene, {markers});
    const auto count = static_cast<std::int64_t>(times.count()),
               bodies = static_cast<std::int64_t>(scene.bodies.size());
    for (std::int64_t k = 0; k < count; ++k) {
      bag.write(times.at(k));
      for (std::size_t i = 0; i < bag.bodyCount(); ++i) {
        const session::MovingBody& body = bag.body(i);
        if (tools::isJudged(body.motion())) worst[i].add(times.at(k), body.attitudeError(), body.energyDrift());
      }
      progress.add(bodies);
    }
    bag.close();
    for (std::size_t i = 0; i < bag.bodyCount(); ++i) {
      const session::MovingBody& body = bag.body(i);
      if (tools::isJudged(body.motion())) out.push_back(tools::worstErrorsText(body.name(), body.motion(), worst[i]));
    }
  } catch (const rosbag::BagException& error) {
    throw OutputError(file.path(),
                      errno ? std::string(std::strerror(errno)) + " (" + error.what() + ")" : error.what());
  }
  return out;
}

/** Prints the first sentences on stderr; a scene of thousands of bodies has too many of them. */
void say(const std::vector<std::string>& sentences) {
  const std::size_t count = std::min(sentences.size(), kMostSaid);
  for (std::size_t i = 0; i < count; ++i) std::cerr << sentences[i] << "\n";
  if (count < sentences.size()) std::cerr << "and " << sentences.size() - count << " more of this kind\n";
}

void run(const Options& options) {
  checkFiles(options);
  const double duration = *options.duration;
  const tools::MoreColumns columns = tools::readColumns(options.columns);
  scene::Scene scene = scene::readFile(options.scene, {duration});
  say(scene.warnings);
  const double rate = options.rate.value_or(scene.rate.value_or(scene::kDefaultRate));
  const tools::SampleTimes times(duration, rate);
  checkSize(options, scene, duration, rate, times);
  say(cost::resolveAccuracies(scene, rate));
  checkSize(options, scene, duration, rate, times);

  const bool to_stdout = options.csv == kStandardOutput;
  std::optional<OutputFile> csv, bag;
  std::vector<OutputFile*> files;
  if (!options.csv.empty() && !to_stdout) files.push_back(&csv.emplace(options.csv, OutputFile::Kind::any));
  if (!options.bag.empty()) files.push_back(&bag.emplace(options.bag, OutputFile::Kind::regular_only));

  const auto states = static_cast<std::int64_t>(times.count() * static_cast<double>(scene.bodies.size()));
  tools::Progress progress(states * (options.csv.empty() || options.bag.empty() ? 1 : 2));
  if (!options.csv.empty()) {
    tools::TextSink out(to_stdout ? STDOUT_FILENO : csv->descriptor(), to_stdout ? "standard output" : options.csv);
    say(tools::writeStateTable(scene, times, columns, out, [&](std::int64_t rows) { progress.add(rows); }));
  }
  if (bag) {
    const std::vector<std::string> worst = writeBag(*bag, scene, times, !options.no_markers, progress);
    if (options.csv.empty()) say(worst);
  }
  OutputFile::commit(files);
}

/** Opens /dev/null in place of closed standard streams, so that no output file takes their descriptors. */
void fillClosedStreams() {
  int descriptor;
  do {
    descriptor = open("/dev/null", O_RDONLY | O_CLOEXEC);
  } while (descriptor >= 0 && descriptor <= STDERR_FILENO);
  if (descriptor >= 0) close(descriptor);
}

}  // namespace

int main(int argc, char** argv) {
  fillClosedStreams();
  OutputFile::catchSignals();
  CLI::App app(kAbout, "simulate");
  Options options;
  app.add_option("scene", options.scene, "The scene file")->required();
  app.add_option("--csv", options.csv, "Write the states there; - is standard output")->check(tools::notEmpty());
  app.add_option("--columns", options.columns, tools::kColumnsHelp)->check(tools::notEmpty());
  app.add_option("--bag", options.bag, "Write a bag there")->check(tools::notEmpty());
  tools::addPositive(app, "--duration", options.duration, "s",
                     "How long to simulate [s]; an accuracy in the scene holds at least so long")
      ->required();
  tools::addPositive(app, "--rate", options.rate, "Hz", "States a second [Hz] (default: the scene's, or else 60)");
  app.add_flag("--no-markers", options.no_markers, "Leave markers out of the bag");
  if (const auto code = tools::parse(app, argc, argv)) return *code;
  return tools::exitCodeOf<BadUse, scene::Error>("simulate", tools::kBadUse, kFailed, [&] { run(options); });
}
