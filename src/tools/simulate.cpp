// A scene file → its motion as CSV, as a bag, or both, without a ROS master.
#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "csv_rows.h"
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
using tools::OutputError;
using tools::OutputFile;

constexpr int kFailed = 1, kBadUse = 2;
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
    "duration. Of a free body that a stepper moves, stderr is told the worst errors of the run.\n"
    "Bag: the node's messages on the node's topics, with stamps from 1 s on; replay.launch shows it, check_bag audits "
    "it.\n"
    "The same scene gives the same bytes, every time.\n\n"
    "A file comes whole or not at all: until it is complete, what was there before stays.\n"
    "Exit status: 0; 1 when a state cannot be computed or a file not be written; 2 for bad use or a bad scene.";

struct Options {
  std::string scene, csv, bag, duration, rate, columns = kPlainColumns;
  bool no_markers = false;
};

struct BadUse : std::runtime_error {
  using std::runtime_error::runtime_error;
};

double readPositive(const char* option, const std::string& text, const char* unit) {
  double value = 0;
  try {
    value = tools::parseNumber(text);
  } catch (const std::invalid_argument& error) {
    throw BadUse(std::string(option) + " " + error.what() + "; allowed: a positive finite number (" + unit + ")");
  }
  if (!(value > 0)) {
    throw BadUse(std::string(option) + " is " + text + "; allowed: a positive finite number (" + unit + ")");
  }
  return value;
}

tools::MoreColumns readColumns(const Options& options) {
  try {
    return tools::readColumns(options.columns);
  } catch (const std::invalid_argument& error) {
    throw BadUse(std::string("--columns: ") + error.what());
  }
}

bool sameFile(const std::string& a, const std::string& b) {
  namespace fs = std::filesystem;
  return fs::weakly_canonical(fs::absolute(a)) == fs::weakly_canonical(fs::absolute(b));
}

void checkFiles(const Options& options) {
  if (options.csv.empty() && options.bag.empty()) {
    throw BadUse("nothing to write: give --csv FILE, --bag FILE, or both");
  }
  if (options.bag == kStandardOutput) throw BadUse("--bag -: a bag needs a file; only --csv goes to standard output");
  if (!options.csv.empty() && !options.bag.empty() && sameFile(options.csv, options.bag)) {
    throw BadUse("--csv and --bag name the same file, " + options.bag);
  }
  for (const std::string& out : {options.csv, options.bag}) {
    if (!out.empty() && sameFile(out, options.scene)) throw BadUse(out + " is the scene itself and would be lost");
  }
}

/** Refuses what would never end. */
void checkSize(const Options& options, const scene::Scene& scene, double duration, double rate,
               const tools::SampleTimes& times) {
  const double rows = times.count() * static_cast<double>(scene.bodies.size());
  if (!(rows <= kMostRows)) {
    throw BadUse("--duration " + numberText(duration, 9) + " s at " + numberText(rate, 9) + " Hz gives " +
                 numberText(rows, 9) + " states; allowed: up to " + numberText(kMostRows, 9));
  }
  if (!options.bag.empty() && duration > node::SceneBag::kLatest) {
    throw BadUse("--duration " + numberText(duration, 9) +
                 " s is more than stamps can hold; allowed with --bag: up to " +
                 numberText(node::SceneBag::kLatest, 9) + " s");
  }
  if (!options.bag.empty() && rate > kFastestBag) {
    throw BadUse("a rate of " + numberText(rate, 9) + " Hz is too fast for stamps; allowed with --bag: up to " +
                 numberText(kFastestBag, 9) + " Hz");
  }
  for (const scene::Body& body : scene.bodies) {
    if (!body.step || duration / *body.step <= kMostSteps) continue;
    throw BadUse("--duration " + numberText(duration, 9) + " s takes body " + body.name + " under " + body.method +
                 " more than " + numberText(kMostSteps, 9) + " steps of " + numberText(*body.step, 9) + " s");
  }
}

/** @return a sentence on the worst errors of each free body that a stepper moves. */
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

/** On stderr; of a scene of thousands not everything. */
void say(const std::vector<std::string>& sentences) {
  const std::size_t count = std::min(sentences.size(), kMostSaid);
  for (std::size_t i = 0; i < count; ++i) std::cerr << sentences[i] << "\n";
  if (count < sentences.size()) std::cerr << "and " << sentences.size() - count << " more of this kind\n";
}

void run(const Options& options) {
  checkFiles(options);
  const double duration = readPositive("--duration", options.duration, "s");
  std::optional<double> given_rate;
  if (!options.rate.empty()) given_rate = readPositive("--rate", options.rate, "Hz");

  const tools::MoreColumns columns = readColumns(options);
  if (options.csv.empty() && options.columns != kPlainColumns)
    throw BadUse("--columns goes with --csv, which is not given");

  scene::Scene scene = scene::readFile(options.scene, {duration});
  say(scene.warnings);
  const double rate = given_rate.value_or(scene.rate.value_or(scene::kDefaultRate));
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

/** No file of ours must come to stand where a closed stream was. */
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
  app.add_option("--csv", options.csv, "Write the states there; - is standard output");
  app.add_option(
      "--columns", options.columns,
      "What the CSV holds: states, and energy (E,Lx,Ly,Lz) and errors (attitude_error,energy_drift) if named");
  app.add_option("--bag", options.bag, "Write a bag there");
  app.add_option("--duration", options.duration,
                 "How long to simulate [s]; an accuracy in the scene holds at least so long")
      ->required();
  app.add_option("--rate", options.rate, "States a second [Hz] (default: the scene's, or else 60)");
  app.add_flag("--no-markers", options.no_markers, "Leave markers out of the bag");
  try {
    app.parse(argc, argv);
    for (const char* option : {"--csv", "--bag", "--columns", "--duration", "--rate"}) {
      if (app.count(option) > 0 && app[option]->as<std::string>().empty()) {
        throw CLI::ValidationError(option, "is empty");
      }
    }
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kBadUse;
  }
  const auto fail = [](int code, const std::exception& error) {
    std::cerr << "simulate: " << error.what() << "\n";
    return code;
  };
  try {
    run(options);
  } catch (const BadUse& error) {
    return fail(kBadUse, error);
  } catch (const scene::Error& error) {
    return fail(kBadUse, error);
  } catch (const std::exception& error) {
    return fail(kFailed, error);
  }
  return 0;
}
