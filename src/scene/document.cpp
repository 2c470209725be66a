#include "document.h"

#include <yaml-cpp/eventhandler.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "place.h"
#include "poinsot/scene/message.h"
#include "poinsot/scene/reader.h"

namespace poinsot::scene {
namespace {

const char* const kOneDocument = "one YAML document";

/** Refuses control characters: yaml-cpp takes some of them as the end of the file and would silently drop the rest. */
void refuseControlCharacters(const std::string& text, const std::string& source) {
  int line = 1;
  for (const char c : text) {
    if (c == '\n') ++line;
    if (static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\r' && c != '\t') {
      throw Error(source + ":" + std::to_string(line) + ": " +
                  expectedGot("YAML text in UTF-8", "a control character"));
    }
  }
}

/** Returns the rest of the line on which the mark is, from the mark on. */
std::string restOfLine(const std::string& text, const YAML::Mark& mark) {
  std::istringstream in(text);
  std::string line;
  for (int i = 0; i <= mark.line; ++i) {
    line.clear();
    std::getline(in, line);
  }
  return line.substr(std::min<std::size_t>(line.size(), static_cast<std::size_t>(mark.column)));
}

/** Goes through one document without keeping it; refuses a second one, and more values or levels than allowed. */
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

  [[noreturn]] void refuse(const YAML::Mark& mark, const std::string& expected, const std::string& got) const {
    throw Error(lineOf(source_, mark) + ": " + expectedGot(expected, got));
  }

  [[noreturn]] void refuseSecond(const YAML::Mark& mark) const {
    const std::string found = restOfLine(text_, mark);
    const bool is_document = mark.column == 0 && found.compare(0, 3, "---") == 0;
    refuse(mark, kOneDocument, is_document ? "a second" : "\"" + shortened(found) + "\" outside of it");
  }

  void count(const YAML::Mark& mark, std::size_t values) {
    values_ += values;
    if (values_ <= kMostValues) return;
    const std::string most = std::to_string(kMostValues);
    refuse(mark, "at most " + most + " values and keys, those behind an alias counted at each use", "more");
  }

  void begin(const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (open_.size() == kMostNested) {
      refuse(mark, "at most " + std::to_string(kMostNested) + " lists and maps within each other", "more");
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
    // YAML::Load reads the first document and ignores the rest; YAML::LoadAll never ends on a text such as ",", which
    // it takes for endless empty documents. So the text is first searched for a second document.
    std::istringstream in(text);
    YAML::Parser parser(in);
    Inspection inspection(text, source);
    if (!parser.HandleNextDocument(inspection)) {
      throw Error(source + ": " + expectedGot(kExpectedScene, "an empty file"));
    }
    parser.HandleNextDocument(inspection);
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw Error(lineOf(source, error.mark) + ": " + expectedGot(kOneDocument, "text that is not YAML", error.msg));
  }
}

}  // namespace poinsot::scene
