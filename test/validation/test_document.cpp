// doc/validation.md shows exactly the figures that are computed here.
#include <gtest/gtest.h>

#include <fstream>

#include "cases.h"

namespace poinsot::validation {
namespace {

/** The lines of a document's tables, without their heads. */
std::vector<std::string> tableRows(std::istream& document) {
  std::vector<std::string> found;
  std::string line;
  for (bool inside = false; std::getline(document, line);) {
    const bool is_row = line.rfind("|", 0) == 0;
    if (line.rfind("|---", 0) == 0) {
      inside = true;
    } else if (inside && is_row) {
      found.push_back(line);
    } else if (!is_row) {
      inside = false;
    }
  }
  return found;
}

TEST(Document, showsJustWhatIsComputed) {
  std::ifstream document(DOCUMENT);
  ASSERT_TRUE(document) << DOCUMENT;
  const std::vector<std::string> shown = tableRows(document);
  std::vector<std::string> computed;
  for (const Case& one : allCases()) {
    for (const std::string& row : rows(one, one.measure(one.setup))) computed.push_back(row);
  }
  EXPECT_EQ(shown, computed);
}

}  // namespace
}  // namespace poinsot::validation
