#pragma once

#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <string>

namespace poinsot::scene {

/** What the top of a scene must be. */
constexpr const char* kExpectedScene = "a map with the keys rate, bodies";

/** The most values and keys that a document may hold, those behind an alias counted at each use. */
constexpr std::size_t kMostValues = 500000;

/** The deepest nesting of lists and maps. */
constexpr std::size_t kMostNested = 100;

/**
 * Returns the tree of a text that holds one YAML document and nothing else. Throws Error, with a line where there is
 * one.
 * @param source stands for the file name in messages.
 */
YAML::Node parseDocument(const std::string& text, const std::string& source);

}  // namespace poinsot::scene
