#pragma once

#include <yaml-cpp/yaml.h>

#include <cstddef>
#include <string>

namespace poinsot::scene {

/** A text as a message shows it: on one line, and not much longer than 60 bytes. */
std::string shortened(const std::string& text);

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

  /** Its entry `index`; this must be a list that has one. */
  Place item(std::size_t index) const;

  /** What stands under this key; its line is the key's where there is no value. */
  Place under(const YAML::Node& key, const YAML::Node& value) const;

  /** The same place, the name shown with it. */
  Place called(const std::string& name) const;

  /** Refuses anything but a list. @param allowed what to say is allowed. */
  void requireList(const std::string& allowed) const;

  /** The node's value as a message shows it: a scalar's text (shortened), "a list of 2", "a map", "null". */
  std::string found() const;

  /** `source:line: path: text`; the line is left out where the tree has none, the path at the top. */
  std::string message(const std::string& text) const;

  /** Throws Error with message("problem; allowed: allowed"). */
  [[noreturn]] void refuse(const std::string& problem, const std::string& allowed) const;

 private:
  YAML::Node node_;
  std::string source_;
  std::string path_;
  YAML::Mark mark_;
};

}  // namespace poinsot::scene
