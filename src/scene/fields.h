#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "place.h"

namespace poinsot::scene {

/** The entries of a map. The constructor refuses anything but a map, keys that are not words, and duplicate keys. */
class Fields {
 public:
  /** @param expected what a message says was expected where the place holds no map. */
  Fields(const Place& place, const std::string& expected);

  /** Refuses every key but these; the message suggests the one that was probably meant. */
  void allowOnly(const std::vector<std::string>& keys) const;

  /** Returns the place under a key, or nothing where there is no such key. */
  std::optional<Place> find(const std::string& key) const;

  /** Returns the place under a key that must be there. @param expected what the key takes, for the message. */
  Place require(const std::string& key, const std::string& expected) const;

  /** Returns the entry of a table that the key `type` names; refuses keys other than `type` and those of the entry. */
  template <class Type>
  const Type& requireType(const std::vector<Type>& table) const {
    std::vector<std::string> names;
    for (const Type& type : table) names.push_back(type.name);
    const std::string name = requireChoice("type", names);
    const auto type = std::find_if(table.begin(), table.end(), [&](const Type& t) { return t.name == name; });
    std::vector<std::string> keys = {"type"};
    keys.insert(keys.end(), type->keys.begin(), type->keys.end());
    allowOnly(keys);
    return *type;
  }

  /** Returns the word under a key that must be there, out of a fixed set. */
  std::string requireChoice(const std::string& key, const std::vector<std::string>& known) const;

  /** Returns the place of the whole map. */
  const Place& place() const { return place_; }

 private:
  struct Field {
    std::string key;
    Place key_place;
    Place value;
  };

  Place place_;
  std::vector<Field> fields_;
};

}  // namespace poinsot::scene
