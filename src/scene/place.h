#pragma once

#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <limits>
#include <string>

namespace poinsot::scene {

/** Returns a text as messages show it: on one line, and cut after about 60 bytes. */
std::string shortened(const std::string& text);

/** Returns `source:line`, or the source alone where the mark is of no line. */
std::string lineOf(const std::string& source, const YAML::Mark& mark);

/**
 * A node of the scene's tree and how to point at it in a message: `bodies[1] "hammer".inertia[2]`, counted from 0.
 * A node with an explicit YAML tag is refused on construction: readers disagree about tags (rosparam turns
 * `!degrees 90` into radians, yaml-cpp would drop the tag).
 */
class Place {
 public:
  /** @param source a file name, or what stands for one. An empty path means the top of the tree. */
  Place(const YAML::Node& node, const std::string& source, const std::string& path = "");
  // YAML::Node's assignment rewires the tree it points into.
  Place(const Place&) = default;
  Place& operator=(const Place&) = delete;

  const YAML::Node& node() const { return node_; }

  /** Returns a scalar's text; empty for anything else. */
  const std::string& scalar() const { return node_.Scalar(); }

  /** Returns entry `index` of this list, which must have one. */
  Place item(std::size_t index) const;

  /** Returns what stands under this key; its line is the key's where there is no value. */
  Place under(const YAML::Node& key, const YAML::Node& value) const;

  /** Returns the same place, the name shown with it. */
  Place called(const std::string& name) const;

  /** Refuses anything but a list of `least` to `most` entries. */
  void requireList(const std::string& expected, std::size_t least = 0,
                   std::size_t most = std::numeric_limits<std::size_t>::max()) const;

  /**
   * Returns the node's value as messages show it: a scalar's text (shortened, and in quotes unless it begins like a
   * number), "a list of 2", "an empty list", "a map", "null".
   */
  std::string found() const;

  /** Returns `source:line: path: text`; the line is left out where the tree has none, the path at the top. */
  std::string message(const std::string& text) const;

  /** Throws Error with message("expected X, got Y: why"). */
  [[noreturn]] void refuse(const std::string& expected, const std::string& got, const std::string& why = "") const;

 private:
  YAML::Node node_;
  std::string source_;
  std::string path_;
  YAML::Mark mark_;
};

}  // namespace poinsot::scene
