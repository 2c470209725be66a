#include "words.h"

#include <algorithm>

#include "characters.h"
#include "poinsot/scene/message.h"

namespace poinsot::scene {
namespace {

bool isValidName(const std::string& name) {
  return !name.empty() && isLetter(name.front()) &&
         std::all_of(name.begin(), name.end(), [](char c) { return isLetter(c) || isDigit(c) || c == '_'; });
}

bool isBooleanOrNull(const std::string& word) {
  return contains({"y", "n", "yes", "no", "on", "off", "true", "false", "null"}, lower(word));
}

}  // namespace

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string readChoice(const Place& place, const std::vector<std::string>& known) {
  const std::string& word = place.scalar();
  if (place.node().IsScalar() && contains(known, word)) return word;
  place.refuse("one of " + joined(known), place.found() + didYouMean(word, known));
}

std::string readName(const Place& place) {
  const std::string& name = place.scalar();
  if (!isValidName(name)) place.refuse(kExpectedName, place.found());
  if (isBooleanOrNull(name)) {
    place.refuse(kExpectedName, place.found(), "YAML readers take this word as a boolean or null");
  }
  return name;
}

}  // namespace poinsot::scene
