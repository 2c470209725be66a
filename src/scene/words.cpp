#include "words.h"

#include <algorithm>
#include <cstdlib>

#include "characters.h"

namespace poinsot::scene {
namespace {

constexpr std::size_t kFurthestSuggestion = 2;  // edits
constexpr std::size_t kLongestSuggested = 40;   // characters; no word of ours is longer

bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/** Levenshtein's distance. */
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

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool isValidName(const std::string& name) {
  return !name.empty() && isLetter(name.front()) &&
         std::all_of(name.begin(), name.end(), [](char c) { return isLetter(c) || isDigit(c) || c == '_'; });
}

bool isBooleanOrNull(std::string word) {
  static const std::vector<std::string> words = {"y", "n", "yes", "no", "on", "off", "true", "false", "null"};
  std::transform(word.begin(), word.end(), word.begin(), lower);
  return contains(words, word);
}

}  // namespace

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string didYouMean(const std::string& word, const std::vector<std::string>& candidates) {
  if (word.size() > kLongestSuggested) return "";
  std::string nearest;
  std::size_t distance = kFurthestSuggestion + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t d = editDistance(word, candidate);
    if (d < distance && d < std::min(word.size(), candidate.size())) {
      distance = d;
      nearest = candidate;
    }
  }
  return nearest.empty() ? "" : ", did you mean \"" + nearest + "\"?";
}

std::string readChoice(const Place& place, const std::vector<std::string>& known) {
  if (!place.node().IsScalar()) place.refuse(place.found() + " is not a word", joined(known));
  const std::string& word = place.node().Scalar();
  if (contains(known, word)) return word;
  place.refuse(place.found() + " is unknown" + didYouMean(word, known), joined(known));
}

std::string readName(const Place& place) {
  const char* const allowed = "a letter, then letters, digits and underscores";
  if (!place.node().IsScalar()) place.refuse(place.found() + " is not a name", allowed);
  const std::string& name = place.node().Scalar();
  if (!isValidName(name)) place.refuse(place.found() + " is not a name", allowed);
  if (isBooleanOrNull(name)) {
    place.refuse(name + " is not a name, because YAML readers take it as a boolean or null",
                 std::string(allowed) + ", and no such word");
  }
  return name;
}

}  // namespace poinsot::scene
