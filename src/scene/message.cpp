#include "poinsot/scene/message.h"

#include <algorithm>
#include <cstddef>

#include "synonyms.h"

namespace poinsot::scene {
namespace {

constexpr std::size_t kFurthestSuggestion = 2;  // edits
constexpr std::size_t kLongestSuggested = 40;   // characters; no word of ours is longer

/** Returns Levenshtein's distance. */
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string expectedGot(const std::string& expected, const std::string& got, const std::string& why) {
  return "expected " + expected + ", got " + got + (why.empty() ? "" : ": " + why);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string didYouMean(const std::string& word, const std::vector<std::string>& candidates) {
  if (word.size() > kLongestSuggested) return "";
  if (const Synonym* synonym = synonymOf(word, candidates)) {
    return std::string(" (did you mean \"") + synonym->meant + '"' + synonym->note + "?)";
  }
  std::string nearest;
  std::size_t distance = kFurthestSuggestion + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t d = editDistance(word, candidate);
    if (d < distance && d < std::min(word.size(), candidate.size())) {
      distance = d;
      nearest = candidate;
    }
  }
  return nearest.empty() ? "" : " (did you mean \"" + nearest + "\"?)";
}

}  // namespace poinsot::scene
