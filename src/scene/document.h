#pragma once

#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <string>

namespace poinsot::scene {

/** How many values and keys a document may hold, those behind an alias counted at each use. */
constexpr std::size_t kMostValues = 500000;

/** How many lists and maps may lie within each other. */
constexpr std::size_t kMostNested = 100;

/**
 * The tree of a text that holds one YAML document and nothing else. Throws Error, with a line where there is one.
 * @param source stands for the file name in messages.
 */
YAML::Node parseDocument(const std::string& text, const std::string& source);

}  // namespace poinsot::scene
