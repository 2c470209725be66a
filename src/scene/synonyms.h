#pragma once

#include <string>
#include <vector>

namespace poinsot::scene {

/** A word that people use, and the one that a scene has for it. */
struct Synonym {
  const char* word;  ///< in small letters
  const char* meant;
  const char* note;  ///< what a message says after the word that is meant; may be empty
};

/** Returns the synonym for a word, in any case, whose meaning is one of the candidates; nullptr where there is none. */
const Synonym* synonymOf(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace poinsot::scene
