#pragma once

#include <optional>
#include <string>
#include <vector>

#include "place.h"

namespace poinsot::scene {

/** The entries of a map. On construction refuses what is no map, keys that are no plain words, and duplicate keys. */
class Fields {
 public:
  /** @param allowed what to say is allowed where the place holds no map. */
  Fields(const Place& place, const std::string& allowed);

  /** Refuses every key but these, and suggests the one that was probably meant. */
  void allowOnly(const std::vector<std::string>& keys) const;

  std::optional<Place> find(const std::string& key) const;

  /** The place under a key that must be there. @param allowed what the key takes, for the message. */
  Place require(const std::string& key, const std::string& allowed) const;

  /** Where the whole map is. */
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
