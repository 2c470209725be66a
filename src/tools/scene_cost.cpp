// A scene file → what each of its bodies costs on this machine, and what each effect's part of it is.
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "command_line.h"
#include "cost_breakdown_text.h"
#include "output_file.h"
#include "poinsot/core/number_text.h"
#include "poinsot/cost/cost_breakdown.h"
#include "poinsot/cost/resolve_accuracy.h"
#include "poinsot/scene/motion_setup.h"
#include "poinsot/scene/reader.h"
#include "standard_output.h"

namespace {

using namespace poinsot;
using tools::BadUse;
using tools::OutputFile;

constexpr int kFailed = 1;
constexpr double kDefaultDuration = 10;  // s
constexpr double kMost = 1e9;            // steps or states of one body: minutes
const char* const kStandardOutput = "-";

const char* const kAbout =
    "Measures what a scene's bodies cost on this machine. For each body: the effects in force, the method and why, CPU "
    "time per\n"
    "step, per state and per simulated second, and the part of each effect in it. Effects that are absent cost 0.\n\n"
    "Methods are chosen as the node chooses them.\n"
    "Exit status: 0; 1 when a state cannot be computed or a file not be written; 2 for bad use or a bad scene.";

struct Options {
  std::string scene, csv;
  std::optional<double> duration, rate;
};

void checkFile(const Options& options) {
  if (options.csv.empty() || options.csv == kStandardOutput) return;
  tools::refuseSameFile("--csv", options.csv, "the scene", options.scene);
}

void checkSize(const scene::Scene& scene, double duration, double rate) {
  if (!(duration * rate <= kMost)) {
    throw BadUse("--duration", "at most " + numberText(kMost) + " states",
                 numberText(duration * rate) + " (" + numberText(duration) + " s at " + numberText(rate) + " Hz)");
  }
  for (const scene::Body& body : scene.bodies) {
    if (!body.step || duration / *body.step <= kMost) continue;
    throw BadUse("--duration", "at most " + numberText(kMost) + " steps of body " + body.name,
                 numberText(duration / *body.step) + " (" + numberText(duration) + " s)");
  }
}

/** Chooses the methods that the scene leaves open; returns the reason for each body's method. */
std::vector<std::string> reasons(scene::Scene& scene, double rate) {
  const std::vector<std::string> choices = cost::resolveAccuracies(scene, rate);
  std::vector<std::string> out;
  std::size_t next = 0;
  for (const scene::Body& body : scene.bodies) {
    if (body.accuracy) {
      const std::string choice = choices.at(next++).substr(body.name.size() + 2);  // "name: "
      out.push_back((body.accuracy->by_default ? "the scene leaves the choice: " : "") + choice);
    } else if (body.method == kClosedForm) {
      out.push_back("nothing turns the body, so that its state at any time is known without steps");
    } else {
      out.push_back("the scene names it");
    }
  }
  return out;
}

cost::CostBreakdown measure(const scene::Body& body, double duration, double rate) {
  try {
    return cost::measureCosts(scene::motionSetup(body), duration, rate);
  } catch (const std::runtime_error& error) {  // range_error, NoConvergence
    throw std::runtime_error("body " + body.name + " under " + body.method + ": " + error.what());
  }
}

void run(const Options& options) {
  checkFile(options);
  const double duration = options.duration.value_or(kDefaultDuration);
  scene::Scene scene = scene::readFile(options.scene, {options.duration});
  for (const std::string& warning : scene.warnings) std::cerr << warning << "\n";
  const double rate = options.rate.value_or(scene.rate.value_or(scene::kDefaultRate));
  checkSize(scene, duration, rate);
  const std::vector<std::string> why = reasons(scene, rate);
  checkSize(scene, duration, rate);

  const bool csv_alone = options.csv == kStandardOutput;
  std::string text = options.scene + ": " + numberText(rate) + " states in a simulated second, measured over " +
                     numberText(duration) + " simulated s\n",
              csv = tools::costBreakdownHeader();
  std::optional<OutputFile> file;  // opened before the measurements, which are in vain where it cannot be written
  if (!options.csv.empty() && !csv_alone) file.emplace(options.csv, OutputFile::Kind::any);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const scene::Body& body = scene.bodies[i];
    const cost::CostBreakdown breakdown = measure(body, duration, rate);
    text += "\n" + tools::costBreakdownText(body, why[i], breakdown);
    csv += tools::costBreakdownRows(body, breakdown);
  }
  if (file) {
    tools::TextSink sink(file->descriptor(), options.csv);
    sink.text() = csv;
    sink.flush();
    OutputFile::commit({&*file});
  }
  std::cout << (csv_alone ? csv : text);
  tools::flushStandardOutput();
}

}  // namespace

int main(int argc, char** argv) {
  OutputFile::catchSignals();
  CLI::App app(kAbout, "scene_cost");
  Options options;
  app.add_option("scene", options.scene, "The scene file")->required();
  tools::addPositive(
      app, "--duration", options.duration, "s",
      "How long to simulate [s] (default: 10); when given, an accuracy in the scene holds at least so long");
  tools::addPositive(app, "--rate", options.rate, "Hz",
                     "States in a simulated second [Hz] (default: the scene's, or else 60)");
  app.add_option("--csv", options.csv, "Write the figures there as CSV too; - is standard output, without the table")
      ->check(tools::notEmpty());
  if (const auto code = tools::parse(app, argc, argv)) return *code;
  return tools::exitCodeOf<BadUse, scene::Error>("scene_cost", tools::kBadUse, kFailed, [&] { run(options); });
}
