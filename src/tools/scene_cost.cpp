// A scene file → what each of its bodies costs on this machine, and what each effect's part of it is.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cost_breakdown_text.h"
#include "csv_rows.h"
#include "output_file.h"
#include "poinsot/core/number_text.h"
#include "poinsot/cost/cost_breakdown.h"
#include "poinsot/cost/resolve_accuracy.h"
#include "poinsot/scene/motion_setup.h"
#include "poinsot/scene/reader.h"
#include "standard_output.h"

namespace {

using namespace poinsot;
using tools::OutputError;
using tools::OutputFile;

constexpr int kFailed = 1, kBadUse = 2;
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
  std::string scene, csv, duration, rate;
};

struct BadUse : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/** Nothing where the option is not given. */
std::optional<double> readPositive(const CLI::App& app, const char* option, const std::string& text) {
  if (app.count(option) == 0) return std::nullopt;
  try {
    if (const double value = tools::parseNumber(text); value > 0) return value;
  } catch (const std::invalid_argument&) {
  }
  throw BadUse(std::string(option) + " is \"" + text + "\"; allowed: a positive finite number");
}

/** @param given that --csv is there at all. */
void checkFile(const Options& options, bool given) {
  if (given && options.csv.empty()) throw BadUse("--csv is empty; allowed: a file, or -");
  if (options.csv.empty() || options.csv == kStandardOutput) return;
  namespace fs = std::filesystem;
  if (fs::weakly_canonical(fs::absolute(options.csv)) == fs::weakly_canonical(fs::absolute(options.scene))) {
    throw BadUse(options.csv + " is the scene itself and would be lost");
  }
}

void checkSize(const scene::Scene& scene, double duration, double rate) {
  if (!(duration * rate <= kMost)) {
    throw BadUse("--duration " + numberText(duration) + " s at " + numberText(rate) + " Hz gives " +
                 numberText(duration * rate) + " states; allowed: up to " + numberText(kMost));
  }
  for (const scene::Body& body : scene.bodies) {
    if (!body.step || duration / *body.step <= kMost) continue;
    throw BadUse("--duration " + numberText(duration) + " s takes body " + body.name + " " +
                 numberText(duration / *body.step) + " steps; allowed: up to " + numberText(kMost));
  }
}

/** Settles methods. @return why each body has its own. */
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
    return cost::measureLedger(scene::motionSetup(body), duration, rate);
  } catch (const std::runtime_error& error) {  // range_error, NoConvergence
    throw std::runtime_error("body " + body.name + " under " + body.method + ": " + error.what());
  }
}

void run(const Options& options, const std::optional<double>& given_duration, const std::optional<double>& given_rate) {
  const double duration = given_duration.value_or(kDefaultDuration);
  scene::Scene scene = scene::readFile(options.scene, {given_duration});
  for (const std::string& warning : scene.warnings) std::cerr << warning << "\n";
  const double rate = given_rate.value_or(scene.rate.value_or(scene::kDefaultRate));
  checkSize(scene, duration, rate);
  const std::vector<std::string> why = reasons(scene, rate);
  checkSize(scene, duration, rate);

  const bool csv_alone = options.csv == kStandardOutput;
  std::string text = options.scene + ": " + numberText(rate) + " states in a simulated second, measured over " +
                     numberText(duration) + " simulated s\n",
              csv = tools::ledgerHeader();
  std::optional<OutputFile> file;  // before the work: where it cannot be written, nothing is to be measured
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
  app.add_option("--duration", options.duration,
                 "How long to simulate [s] (default: 10); when given, an accuracy in the scene holds at least so long");
  app.add_option("--rate", options.rate, "States in a simulated second [Hz] (default: the scene's, or else 60)");
  app.add_option("--csv", options.csv, "Write the figures there as CSV too; - is standard output, without the table");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kBadUse;
  }
  const auto fail = [](int code, const std::exception& error) {
    std::cerr << "scene_cost: " << error.what() << "\n";
    return code;
  };
  try {
    checkFile(options, app.count("--csv") > 0);
    run(options, readPositive(app, "--duration", options.duration), readPositive(app, "--rate", options.rate));
  } catch (const BadUse& error) {
    return fail(kBadUse, error);
  } catch (const scene::Error& error) {
    return fail(kBadUse, error);
  } catch (const std::exception& error) {
    return fail(kFailed, error);
  }
  return 0;
}
