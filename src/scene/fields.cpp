#include "fields.h"

#include <algorithm>
#include <set>

#include "words.h"

namespace poinsot::scene {

Fields::Fields(const Place& place, const std::string& allowed) : place_(place) {
  if (!place.node().IsMap()) place.refuse(place.found() + " is not a map", allowed);
  std::set<std::string> keys;
  for (const auto& entry : place.node()) {
    if (!entry.first.IsScalar()) place.refuse("a key is not a word", allowed);
    const std::string key = entry.first.Scalar();
    const Place key_place = place.under(entry.first, entry.first);
    if (!keys.insert(key).second) key_place.refuse("duplicate key", "every key once");
    fields_.push_back({key, key_place, place.under(entry.first, entry.second)});
  }
}

void Fields::allowOnly(const std::vector<std::string>& keys) const {
  for (const Field& field : fields_) {
    if (std::find(keys.begin(), keys.end(), field.key) != keys.end()) continue;
    field.key_place.refuse("unknown key" + didYouMean(field.key, keys), joined(keys));
  }
}

std::optional<Place> Fields::find(const std::string& key) const {
  for (const Field& field : fields_) {
    if (field.key == key) return field.value;
  }
  return std::nullopt;
}

Place Fields::require(const std::string& key, const std::string& allowed) const {
  const std::optional<Place> found = find(key);
  if (!found) place_.refuse("the key " + key + " is missing", key + ", " + allowed);
  return *found;
}

}  // namespace poinsot::scene
