#include "place.h"

#include "poinsot/scene/reader.h"

namespace poinsot::scene {
namespace {

constexpr std::size_t kLongestShown = 60;  // bytes of a value that a message repeats

bool hasExplicitTag(const YAML::Node& node) {
  const std::string& tag = node.Tag();  // "?" marks a plain, "!" a quoted scalar
  return !(tag.empty() || tag == "?" || tag == "!");
}

}  // namespace

std::string shortened(const std::string& text) {
  std::string shown;
  for (const char c : text) {
    if (shown.size() >= kLongestShown && (c & 0xC0) != 0x80) return shown + "…";  // not inside a UTF-8 sequence
    shown += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return shown;
}

Place::Place(const YAML::Node& node, const std::string& source, const std::string& path)
    : node_(node), source_(source), path_(path), mark_(node.Mark()) {
  if (hasExplicitTag(node)) refuse("the tag " + shortened(node.Tag()) + " is not understood", "no tags");
}

Place Place::item(std::size_t index) const {
  return {node_[index], source_, path_ + "[" + std::to_string(index) + "]"};
}

Place Place::under(const YAML::Node& key, const YAML::Node& value) const {
  const std::string name = shortened(key.Scalar());
  Place place(value, source_, path_.empty() ? name : path_ + "." + name);
  if (value.IsNull()) place.mark_ = key.Mark();
  return place;
}

Place Place::called(const std::string& name) const {
  return {node_, source_, path_ + " \"" + shortened(name) + "\""};
}

void Place::requireList(const std::string& allowed) const {
  if (!node_.IsSequence()) refuse(found() + " is not a list", allowed);
}

std::string Place::found() const {
  switch (node_.Type()) {
    case YAML::NodeType::Scalar: {
      const std::string text = shortened(node_.Scalar());
      return text.empty() || text.find(' ') != std::string::npos ? '"' + text + '"' : text;
    }
    case YAML::NodeType::Sequence:
      return "a list of " + std::to_string(node_.size());
    case YAML::NodeType::Map:
      return "a map";
    case YAML::NodeType::Null:
      return "null";
    case YAML::NodeType::Undefined:
      break;
  }
  return "nothing";
}

std::string Place::message(const std::string& text) const {
  std::string out = source_;
  if (!mark_.is_null()) out += ":" + std::to_string(mark_.line + 1);
  out += ": ";
  if (!path_.empty()) out += path_ + ": ";
  return out + text;
}

void Place::refuse(const std::string& problem, const std::string& allowed) const {
  throw Error(message(problem + "; allowed: " + allowed));
}

}  // namespace poinsot::scene
