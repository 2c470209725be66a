#pragma once

#include <string>
#include <vector>

#include "place.h"

namespace poinsot::scene {

/** "a, b, c". */
std::string joined(const std::vector<std::string>& words);

/** `, did you mean "step"?` where one of the candidates is at most two edits away, else nothing. */
std::string didYouMean(const std::string& word, const std::vector<std::string>& candidates);

/** One word out of a fixed set, such as a type. */
std::string readChoice(const Place& place, const std::vector<std::string>& known);

/**
 * A body's name: a letter, then letters, digits and underscores. Words that YAML 1.1 takes as boolean or null are
 * refused, quoted or not: a parameter tree does not tell `yes` from `true`, nor a quoted `true` from a plain one.
 */
std::string readName(const Place& place);

}  // namespace poinsot::scene
