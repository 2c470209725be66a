// Every row of test/data through the program, by its default method: the same tolerance as of the closed form itself.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <vector>

#include "row_judge.h"
#include "run_program.h"

namespace poinsot {
namespace {

struct File {
  const char* name;
  std::size_t rows;
  std::string path() const { return TEST_DATA_DIR "/" + std::string(name); }
};

const File kPublished{"public.csv", 69}, kOthers{"closed_form_rows.csv", 313};

std::string contentOf(const File& file) {
  std::ostringstream out;
  out << std::ifstream(file.path(), std::ios::binary).rdbuf();
  return out.str();
}

/** The same table with the hexadecimal inputs under the names that the program reads, the decimal ones under others. */
std::string hexadecimalContentOf(const File& file) {
  const std::string content = contentOf(file);
  const std::size_t begin = content.find("\nid,") + 1, end = content.find('\n', begin);
  std::istringstream header(content.substr(begin, end - begin));
  std::string names;
  for (std::string name; std::getline(header, name, ',');) {
    static const std::string kSuffix = "_hex";
    const bool is_hexadecimal =
        name.size() > kSuffix.size() && name.compare(name.size() - kSuffix.size(), kSuffix.size(), kSuffix) == 0;
    names += (names.empty() ? "" : ",") + (is_hexadecimal ? name.substr(0, name.size() - kSuffix.size())
                                           : name == "id" ? name
                                                          : name + "_decimal");
  }
  return content.substr(0, begin) + names + content.substr(end);
}

struct OutputRow {
  std::string id;
  std::vector<double> values;  ///< t, qw, qx, qy, qz, O1, O2, O3
};

std::vector<OutputRow> parsed(const std::string& out) {
  std::istringstream lines(out);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "id,t,qw,qx,qy,qz,O1,O2,O3");
  std::vector<OutputRow> rows;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    OutputRow row;
    std::getline(cells, row.id, ',');
    for (std::string cell; std::getline(cells, cell, ',');) {
      char* end = nullptr;
      row.values.push_back(std::strtod(cell.c_str(), &end));
      EXPECT_EQ(*end, '\0') << line;
    }
    EXPECT_EQ(row.values.size(), 8u) << line;
    row.values.resize(8);
    rows.push_back(row);
  }
  return rows;
}

class PropagateInClosedForm : public testing::TestWithParam<File> {};

TEST_P(PropagateInClosedForm, everyRow) {
  const File file = GetParam();
  const std::vector<ReferenceRow> truth = readReferenceRows(file.path());
  ASSERT_EQ(truth.size(), file.rows);
  // With the newest instructions of this processor, and as on older ones.
  for (const char* level : {"", "POINSOT_SIMD=x86-64-v3 ", "POINSOT_SIMD=baseline "}) {
    const Outcome outcome = runProgram(level + shellWord(PROPAGATE), hexadecimalContentOf(file));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const std::vector<OutputRow> rows = parsed(outcome.out);
    ASSERT_EQ(rows.size(), file.rows);
    RowJudge judge;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const std::vector<double>& v = rows[i].values;
      ASSERT_EQ(rows[i].id, truth[i].id);
      ASSERT_EQ(v[0], truth[i].t);
      EXPECT_GE(v[1], 0) << rows[i].id;
      judge.judge(truth[i], {v[1], v[2], v[3], v[4]}, {v[5], v[6], v[7]}, std::string(level) + "propagate");
    }
    judge.print(std::string(level) + "propagate, " + file.name);
  }
}

TEST_P(PropagateInClosedForm, decimalNumbersGiveTheSameBytes) {
  const Outcome hexadecimal = runProgram(shellWord(PROPAGATE), hexadecimalContentOf(GetParam()));
  const Outcome decimal = runProgram(shellWord(PROPAGATE), contentOf(GetParam()));
  EXPECT_EQ(decimal.exit_code, 0) << decimal.err;
  EXPECT_EQ(decimal.out, hexadecimal.out);
  EXPECT_EQ(runProgram(shellWord(PROPAGATE) + " --method closed_form", contentOf(GetParam())).out, decimal.out);
}

INSTANTIATE_TEST_SUITE_P(Files, PropagateInClosedForm, testing::Values(kPublished, kOthers),
                         [](const auto& instance) { return instance.index == 0 ? "published" : "others"; });

TEST(PropagateInClosedFormTable, hexadecimalColumnsTakeThePlaceOfTheDecimalOnes) {
  // Else the rows would be judged on the decimal columns alone.
  std::istringstream lines(hexadecimalContentOf(kPublished));
  std::string line;
  while (std::getline(lines, line) && line[0] == '#') {
  }
  EXPECT_NE(line.find(",mu1_decimal,"), std::string::npos) << line;
  EXPECT_NE(line.find(",mu1,"), std::string::npos) << line;
  EXPECT_EQ(line.find("_hex"), std::string::npos) << line;
  EXPECT_LT(line.find("t_decimal"), line.find(",mu1,"));
}

}  // namespace
}  // namespace poinsot
