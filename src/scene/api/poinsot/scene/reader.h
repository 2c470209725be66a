#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <stdexcept>
#include <string>

#include "poinsot/scene/scene.h"

namespace poinsot::scene {

/**
 * A scene that is refused. what() reads `source:line: place: expected X, got Y`, for example
 * `spin.yaml:4: bodies[0] "top".inertia[2]: expected a positive finite number (kg·m²), got -3`.
 * Entries are counted from 0; the line is left out where a tree has none.
 */
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/** What a program knows, so that the scene need not say it. */
struct ReadOptions {
  /** How long the program follows the motion [s]: every accuracy holds at least so long, even without a horizon. */
  std::optional<double> horizon;
};

/** Returns the tree of a file that holds one YAML document, within the limits of doc/scene_file.md. Throws Error. */
YAML::Node readDocument(const std::string& path);

/** Reads and validates a scene file, doc/scene_file.md. Throws Error. */
Scene readFile(const std::string& path, const ReadOptions& options = {});

/**
 * Reads and validates a tree that came from elsewhere, such as a parameter server. A number may be any scalar whose
 * text is one, so that trees whose reader took `1e-9` for a string give the scene that the file gives. Throws Error.
 * @param source stands for the file name in messages.
 */
Scene readTree(const YAML::Node& tree, const std::string& source, const ReadOptions& options = {});

/** Returns a step [s] under the rules of a body's key `step`. Throws Error. @param source names the place. */
double readStep(const YAML::Node& node, const std::string& source);

/** Returns a rate [Hz] under the rules of a scene's key `rate`. Throws Error. @param source names the place. */
double readRate(const YAML::Node& node, const std::string& source);

}  // namespace poinsot::scene
