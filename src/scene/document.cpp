#include "document.h"

#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "place.h"
#include "poinsot/scene/reader.h"

namespace poinsot::scene {
namespace {

const char* const kOneDocument = "; allowed: one YAML document";

std::string placeIn(const std::string& source, const YAML::Mark& mark) {
  return source + (mark.is_null() ? "" : ":" + std::to_string(mark.line + 1));
}

/** yaml-cpp takes some control characters as the end of the file and would drop the rest without a word. */
void refuseControlCharacters(const std::string& text, const std::string& source) {
  int line = 1;
  for (const char c : text) {
    if (c == '\n') ++line;
    if (static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\r' && c != '\t') {
      throw Error(source + ":" + std::to_string(line) + ": a control character; allowed: YAML text in UTF-8");
    }
  }
}

/** The line of the text on which the mark is, from the mark on. */
std::string restOfLine(const std::string& text, const YAML::Mark& mark) {
  std::istringstream in(text);
  std::string line;
  for (int i = 0; i <= mark.line; ++i) {
    line.clear();
    std::getline(in, line);
  }
  return line.substr(std::min<std::size_t>(line.size(), static_cast<std::size_t>(mark.column)));
}

/** Goes through one document without keeping it; refuses a second one, and more values than a tree may have. */
class Inspection : public YAML::EventHandler {
 public:
  Inspection(const std::string& text, const std::string& source) : text_(text), source_(source) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (started_) refuseSecond(mark);
    started_ = true;
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { count(mark, 1); }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t, const std::string&) override {
    count(mark, 1);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto collection = values_of_.find(anchor);
    count(mark, collection == values_of_.end() ? 1 : collection->second);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    begin(mark, anchor);
  }
  void OnSequenceEnd() override { end(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    begin(mark, anchor);
  }
  void OnMapEnd() override { end(); }

 private:
  struct Collection {
    YAML::anchor_t anchor;
    std::size_t values_before;
  };

  [[noreturn]] void refuseSecond(const YAML::Mark& mark) const {
    const std::string found = restOfLine(text_, mark);
    const bool is_document = mark.column == 0 && found.compare(0, 3, "---") == 0;
    throw Error(placeIn(source_, mark) + ": " +
                (is_document ? "a second YAML document" : "\"" + shortened(found) + "\" outside of the YAML document") +
                kOneDocument);
  }

  void count(const YAML::Mark& mark, std::size_t values) {
    values_ += values;
    if (values_ <= kMostValues) return;
    throw Error(placeIn(source_, mark) + ": more than " + std::to_string(kMostValues) +
                " values and keys, those behind an alias counted at each use; allowed: up to " +
                std::to_string(kMostValues));
  }

  void begin(const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (open_.size() == kMostNested) {
      throw Error(placeIn(source_, mark) + ": more than " + std::to_string(kMostNested) +
                  " lists and maps within each other; allowed: up to " + std::to_string(kMostNested));
    }
    open_.push_back({anchor, values_});
    count(mark, 1);
  }

  void end() {
    if (open_.back().anchor != 0) values_of_[open_.back().anchor] = values_ - open_.back().values_before;
    open_.pop_back();
  }

  const std::string& text_;
  const std::string& source_;
  bool started_ = false;
  std::size_t values_ = 0;
  std::vector<Collection> open_;                     // the innermost last
  std::map<YAML::anchor_t, std::size_t> values_of_;  // of lists and maps with an anchor
};

}  // namespace

YAML::Node parseDocument(const std::string& text, const std::string& source) {
  refuseControlCharacters(text, source);
  try {
    // YAML::Load takes the first document and leaves what follows unread; YAML::LoadAll never ends on a text such as
    // ",", of which it makes empty documents for ever. So look first whether anything follows, at most once.
    std::istringstream in(text);
    YAML::Parser parser(in);
    Inspection inspection(text, source);
    if (!parser.HandleNextDocument(inspection)) {
      throw Error(source + ": the file is empty; allowed: a map with the keys rate, bodies");
    }
    parser.HandleNextDocument(inspection);
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw Error(placeIn(source, error.mark) + ": not YAML, " + error.msg + kOneDocument);
  }
}

}  // namespace poinsot::scene
