#pragma once

#include <string>
#include <vector>

#include "place.h"

namespace poinsot::scene {

bool contains(const std::vector<std::string>& words, const std::string& word);

/** Returns a word out of a fixed set, such as a type; refuses any other. */
std::string readChoice(const Place& place, const std::vector<std::string>& known);

/** What a body's name consists of. */
constexpr const char* kExpectedName = "a letter, then letters, digits and underscores";

/**
 * Returns a body's name. Words that YAML 1.1 takes as boolean or null are refused, quoted or not: a parameter tree does
 * not tell `yes` from `true`, nor a quoted `true` from a plain one.
 */
std::string readName(const Place& place);

}  // namespace poinsot::scene
