#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <stdexcept>
#include <string>

#include "poinsot/scene/scene.h"

namespace poinsot::scene {

/**
 * A scene that is refused. what() reads `source:line: place: what was found; allowed: what is`, for example
 * `spin.yaml:4: bodies[0] "top".inertia[2]: -3 is not positive; allowed: a positive finite number (kg·m²)`.
 * Entries are counted from 0; the line is left out where a tree has none.
 */
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/** What a program knows that the scene need not say. */
struct ReadOptions {
  /** For how long the program will look at the motion [s]: every accuracy holds at least so long, and need not say it.
   */
  std::optional<double> horizon;
};

/** The tree of a file that holds one YAML document, within the limits of doc/scene_file.md. Throws Error. */
YAML::Node readDocument(const std::string& path);

/** Reads and validates a scene file, doc/scene_file.md. Throws Error. */
Scene readFile(const std::string& path, const ReadOptions& options = {});

/**
 * Reads and validates a tree that came from elsewhere, such as a parameter server. A number may be any scalar whose
 * text is one, so that trees whose reader took `1e-9` for a string give the scene that the file gives. Throws Error.
 * @param source stands for the file name in messages.
 */
Scene readTree(const YAML::Node& tree, const std::string& source, const ReadOptions& options = {});

/** A rate as the key `rate` of a scene takes it [Hz], wherever it stands. Throws Error. @param source names the place.
 */
double readRate(const YAML::Node& node, const std::string& source);

}  // namespace poinsot::scene
