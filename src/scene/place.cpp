#include "place.h"

#include "poinsot/scene/message.h"
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

std::string lineOf(const std::string& source, const YAML::Mark& mark) {
  return mark.is_null() ? source : source + ":" + std::to_string(mark.line + 1);
}

Place::Place(const YAML::Node& node, const std::string& source, const std::string& path)
    : node_(node), source_(source), path_(path), mark_(node.Mark()) {
  if (hasExplicitTag(node)) refuse("no tags", "the tag " + shortened(node.Tag()));
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

void Place::requireList(const std::string& expected, std::size_t least, std::size_t most) const {
  if (!node_.IsSequence() || node_.size() < least || node_.size() > most) refuse(expected, found());
}

std::string Place::found() const {
  switch (node_.Type()) {
    case YAML::NodeType::Scalar: {
      const std::string text = shortened(node_.Scalar());
      const bool like_number = text.find_first_of("+-.0123456789") == 0 && text.find(' ') == std::string::npos;
      return like_number ? text : '"' + text + '"';
    }
    case YAML::NodeType::Sequence:
      return node_.size() == 0 ? "an empty list" : "a list of " + std::to_string(node_.size());
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
  return lineOf(source_, mark_) + ": " + (path_.empty() ? "" : path_ + ": ") + text;
}

void Place::refuse(const std::string& expected, const std::string& got, const std::string& why) const {
  throw Error(message(expectedGot(expected, got, why)));
}

}  // namespace poinsot::scene
