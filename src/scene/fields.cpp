#include "fields.h"

#include <set>

#include "poinsot/scene/message.h"
#include "words.h"

namespace poinsot::scene {

Fields::Fields(const Place& place, const std::string& expected) : place_(place) {
  if (!place.node().IsMap()) place.refuse(expected, place.found());
  std::set<std::string> keys;
  for (const auto& entry : place.node()) {
    const Place key_place = place.under(entry.first, entry.first);
    if (!entry.first.IsScalar()) place.refuse("words as keys", key_place.found());
    const std::string key = entry.first.Scalar();
    if (!keys.insert(key).second) key_place.refuse("every key once", "a duplicate key");
    fields_.push_back({key, key_place, place.under(entry.first, entry.second)});
  }
}

void Fields::allowOnly(const std::vector<std::string>& keys) const {
  for (const Field& field : fields_) {
    if (contains(keys, field.key)) continue;
    field.key_place.refuse("one of the keys " + joined(keys), field.key_place.found() + didYouMean(field.key, keys));
  }
}

std::optional<Place> Fields::find(const std::string& key) const {
  for (const Field& field : fields_) {
    if (field.key == key) return field.value;
  }
  return std::nullopt;
}

Place Fields::require(const std::string& key, const std::string& expected) const {
  const std::optional<Place> found = find(key);
  if (!found) place_.refuse("the key " + key + ", " + expected, "none");
  return *found;
}

std::string Fields::requireChoice(const std::string& key, const std::vector<std::string>& known) const {
  return readChoice(require(key, "one of " + joined(known)), known);
}

}  // namespace poinsot::scene
