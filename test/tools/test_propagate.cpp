// The program as its users meet it: a process with arguments, stdin, stdout, stderr and an exit code.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "poinsot/core/closed_form.h"
#include "poinsot/core/method.h"
#include "poinsot/core/rotation.h"
#include "run_program.h"

namespace poinsot {
namespace {

const std::string kHeader = "id,mu1,mu2,mu3,q0w,q0x,q0y,q0z,O01,O02,O03,t\n";
const std::string kRow = "a,1,2,3,1,0,0,0,0.01,1,0.02,2.5\n";
const std::string kOutputHeader = "id,t,qw,qx,qy,qz,O1,O2,O3\n";

Outcome propagate(const std::string& arguments, const std::string& input) {
  return runProgram(shellWord(PROPAGATE) + " " + arguments, input);
}

Outcome rk4(const std::string& input) {
  return propagate("--method rk4 --step 0.01", input);
}

struct OutputRow {
  std::string id;
  double t;
  Eigen::Quaterniond attitude;
  Eigen::Vector3d omega;
};

std::vector<OutputRow> parsed(const std::string& out) {
  std::istringstream in(out);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line + "\n", kOutputHeader);
  std::vector<OutputRow> rows;
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    std::string id, cell;
    std::getline(cells, id, ',');
    std::vector<double> v;
    while (std::getline(cells, cell, ',')) v.push_back(std::strtod(cell.c_str(), nullptr));
    if (v.size() != 8) {
      ADD_FAILURE() << line;
      continue;
    }
    rows.push_back({id, v[0], Eigen::Quaterniond(v[1], v[2], v[3], v[4]), {v[5], v[6], v[7]}});
  }
  return rows;
}

void expectRefused(const Outcome& outcome, const std::vector<std::string>& mentioned) {
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  for (const std::string& word : mentioned) {
    EXPECT_NE(outcome.err.find(word), std::string::npos) << "\"" << word << "\" in: " << outcome.err;
  }
}

/** A row with one cell replaced; the columns in the order of kHeader. */
std::string rowWith(int column, const std::string& value) {
  std::vector<std::string> cells = {"a", "1", "2", "3", "1", "0", "0", "0", "0.01", "1", "0.02", "2.5"};
  cells[column] = value;
  std::string row = cells[0];
  for (std::size_t i = 1; i < cells.size(); ++i) row += "," + cells[i];
  return row + "\n";
}

TEST(Propagate, takesEqualStepsThatReachTheTimeExactly) {
  for (const Method& method : freeMethods()) {
    for (const double t : {2.5, -2.5, 2.504, 1e-3}) {
      const int n = static_cast<int>(std::ceil(std::abs(t) / 0.01));
      RotationState state = RotationState::fromOmega({1, 2, 3}, Eigen::Quaterniond::Identity(), {0.01, 1, 0.02});
      method.make({1, 2, 3})->advance(state, 0, t / n, n);
      if (state.attitude.w() < 0) state.attitude.coeffs() *= -1;
      char time[32];
      std::snprintf(time, sizeof time, "%.17g", t);
      const Outcome outcome =
          propagate("--step 0.01 --method " + std::string(method.name), kHeader + rowWith(11, time));
      EXPECT_EQ(outcome.exit_code, 0);
      EXPECT_EQ(outcome.err, "");
      const std::vector<OutputRow> rows = parsed(outcome.out);
      ASSERT_EQ(rows.size(), 1u);
      EXPECT_EQ(rows[0].id, "a");
      EXPECT_EQ(rows[0].t, t);
      EXPECT_EQ(rows[0].attitude.coeffs(), state.attitude.coeffs());  // 17 digits bring every bit back
      EXPECT_EQ(rows[0].omega, state.omegaPrincipal({1, 2, 3}));
    }
  }
}

TEST(Propagate, timeZeroGivesTheNormalisedInput) {
  for (const char* way : {"", "--method rk4 --step 0.01"}) {
    const Outcome outcome =
        propagate(way, kHeader + "a,1,2,3,-2,0,4,4,0.1,-0.2,1e-300,0\nb,1,2,3,0,0,0,5,0x1.8p-3,2,3,-0.0\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out,
              kOutputHeader +
                  "a,0,0.33333333333333331,0,-0.66666666666666663,-0.66666666666666663,0.10000000000000001,"
                  "-0.20000000000000001,1e-300\nb,-0,0,0,0,1,0.1875,2,3\n");
  }
}

TEST(Propagate, quaternionsOfAnySizeAreNormalised) {
  for (const char* size : {"1e-320", "1e-200", "1e200", "1e308"}) {
    const std::string row = std::string("a,1,2,3,") + size + "," + size + ",0,0,0.01,1,0.02,0\n";
    const std::vector<OutputRow> rows = parsed(rk4(kHeader + row).out);
    ASSERT_EQ(rows.size(), 1u) << size;
    EXPECT_NEAR(rows[0].attitude.w(), std::sqrt(0.5), 1e-16);
    EXPECT_NEAR(rows[0].attitude.x(), std::sqrt(0.5), 1e-16);
  }
}

TEST(Propagate, theScalarPartIsNotNegative) {
  std::string input = kHeader;
  for (int i = 0; i < 50; ++i) input += rowWith(11, std::to_string(0.7 * i));
  for (const OutputRow& row : parsed(rk4(input).out)) EXPECT_GE(row.attitude.w(), 0);
}

TEST(Propagate, publishedRows) {
  // Those that are short enough for small steps; --step so that rk4's own error is below 1e-9.
  std::ifstream file(TEST_DATA_DIR "/public.csv");
  std::string line, input;
  std::vector<Eigen::Quaterniond> truth;
  while (std::getline(file, line)) {
    std::vector<std::string> cells(1);
    for (const char c : line) {
      if (c == ',') {
        cells.emplace_back();
      } else {
        cells.back() += c;
      }
    }
    if (line[0] == '#' || cells[0] == "id") {
      input += line + "\n";
    } else if (std::abs(std::stod(cells[11])) <= 10 && cells[0] < "P055") {
      input += line + "\n";
      truth.emplace_back(std::stod(cells[12]), std::stod(cells[13]), std::stod(cells[14]), std::stod(cells[15]));
    }
  }
  const Outcome outcome = propagate("--method rk4 --step 0.001", input);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::vector<OutputRow> rows = parsed(outcome.out);
  ASSERT_EQ(rows.size(), truth.size());
  ASSERT_GE(rows.size(), 25u);
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_LE(angleBetween(rows[i].attitude, truth[i]), 1e-8) << rows[i].id;
}

TEST(Propagate, columnsInAnyOrderOthersIgnoredCommentsSkipped) {
  const std::string expected = rk4(kHeader + kRow).out;
  EXPECT_NE(expected, "");
  for (const std::string& input :
       {"# a comment\n\n" + kHeader + "#,,,\n  # another\n" + kRow + "\n   \n",
        std::string(
            "t,note,O03,O02,O01,q0z,q0y,q0x,q0w,mu3,mu2,mu1,id,note\n2.5,what,.02,1.0,1e-2,0,-0,0,1,3e0,+2,1.,a,x\n"),
        std::string(" id , mu1,mu2 ,mu3,q0w,q0x,q0y,q0z,O01,O02,O03,t\na, 1,2 ,\t3,1,0,0,0,0.01,1,0.02,2.5"),
        "\xEF\xBB\xBF" + kHeader + kRow,
        std::string("id,mu1,mu2,mu3,q0w,q0x,q0y,q0z,O01,O02,O03,t\r\na,1,2,3,1,0,0,0,0.01,1,0.02,2.5\r\n\r\n")}) {
    const Outcome outcome = rk4(input);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, expected) << input;
  }
}

TEST(Propagate, moreColumns) {
  const auto rowOf = [](const Outcome& outcome, const std::string& header) {
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    std::istringstream in(outcome.out);
    std::string line, cell;
    std::getline(in, line);
    EXPECT_EQ(line, "id,t,qw,qx,qy,qz,O1,O2,O3" + header);
    std::getline(in, line);
    std::istringstream cells(line);
    std::getline(cells, cell, ',');
    std::vector<double> out;
    while (std::getline(cells, cell, ',')) out.push_back(std::strtod(cell.c_str(), nullptr));
    return out;
  };
  const std::string every = "--columns states,energy,errors", header = ",E,Lx,Ly,Lz,attitude_error,energy_drift";
  const auto exact = rowOf(propagate(every, kHeader + kRow), header);
  const auto stepped = rowOf(propagate("--method lie_euler --step 0.01 " + every, kHeader + kRow), header);
  ASSERT_EQ(exact.size(), 14u);
  ASSERT_EQ(stepped.size(), 14u);
  const Eigen::Vector3d moments(1, 2, 3), start(0.01, 1, 0.02);
  const auto attitude = [](const std::vector<double>& v) { return Eigen::Quaterniond(v[1], v[2], v[3], v[4]); };
  for (const auto& v : {exact, stepped}) {
    const Eigen::Vector3d omega(v[5], v[6], v[7]), momentum = attitude(v) * moments.cwiseProduct(omega).eval();
    EXPECT_NEAR(v[8], 0.5 * omega.dot(moments.cwiseProduct(omega)), 1e-15);
    EXPECT_LT((Eigen::Vector3d(v[9], v[10], v[11]) - momentum).norm(), 1e-15);
    EXPECT_NEAR(v[13], v[8] / (0.5 * start.dot(moments.cwiseProduct(start))) - 1, 1e-15);
  }
  EXPECT_EQ(exact[12], 0);
  EXPECT_NEAR(stepped[12], attitude(exact).angularDistance(attitude(stepped)), 1e-7);
  EXPECT_GT(stepped[12], 1e-5);
  EXPECT_GT(std::abs(stepped[13]), 1e-6);

  const std::string plain = propagate("", kHeader + kRow).out;
  EXPECT_EQ(propagate("--columns states", kHeader + kRow).out, plain);
  EXPECT_EQ(rowOf(propagate("--columns energy", kHeader + kRow), ",E,Lx,Ly,Lz").size(), 12u);
  expectRefused(propagate("--columns speed", kHeader + kRow),
                {"--columns: expected states, energy and errors", "\"speed\""});
}

TEST(Propagate, hexadecimalNumbersAreExact) {
  const std::string decimal = kHeader + "a,1,2,3,1,0,0,0,0.10000000000000001,1,0.02,2.5\n";
  const std::string hex =
      kHeader + "a,0x1p0,0X1P+1,0x1.8p1,1,0,0,0,0x1.999999999999ap-4,1,0x1.47ae147ae147bp-6,0x5p-1\n";
  EXPECT_EQ(rk4(hex).out, rk4(decimal).out);
  EXPECT_EQ(rk4(hex).exit_code, 0);
  EXPECT_EQ(propagate("--method rk4 --step 0x1p-7", hex).out, propagate("--method rk4 --step 0.0078125", hex).out);
}

TEST(Propagate, decimalPointWhateverTheLocale) {
  const std::string command = "LC_ALL=de_DE.UTF-8 LC_NUMERIC=de_DE.UTF-8 " + shellWord(PROPAGATE);
  EXPECT_EQ(runProgram(command + " --method rk4 --step 0.01", kHeader + kRow).out, rk4(kHeader + kRow).out);
}

TEST(Propagate, idsPassThroughUnchanged) {
  const std::string ids[] = {"P001", " spaced out ", "", "näh;'|\\", "0012.50"};
  std::string input = kHeader;
  for (const std::string& id : ids) input += rowWith(0, id);
  const std::vector<OutputRow> rows = parsed(rk4(input).out);
  ASSERT_EQ(rows.size(), 5u);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(rows[i].id, ids[i]);
}

TEST(Propagate, noRowsIsAnEmptyTable) {
  for (const std::string& input : {kHeader, kHeader.substr(0, kHeader.size() - 1), kHeader + "# nothing\n"}) {
    const Outcome outcome = rk4(input);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out, kOutputHeader);
  }
}

TEST(Propagate, badCellsAreRefusedWithLineAndReason) {
  const char* columns[] = {"id", "mu1", "mu2", "mu3", "q0w", "q0x", "q0y", "q0z", "O01", "O02", "O03", "t"};
  for (int column = 1; column < 12; ++column) {
    for (const char* bad :
         {"", "x", "1x", "1 2", "nan", "NaN", "inf", "-inf", "1e999", "0x", "1e", "--1", "1_0", "0b1", "1;5", "\v1"}) {
      expectRefused(rk4("# comment\n" + kHeader + kRow + "\n" + rowWith(column, bad) + kRow),
                    {"line 5", columns[column]});
    }
  }
  expectRefused(rk4(kHeader + rowWith(2, "nan")), {"line 2", "mu2: expected a finite number, got \"nan\"\n"});
  expectRefused(rk4(kHeader + rowWith(11, "1s")), {"line 2", "t: expected a finite number, got \"1s\"\n"});
}

TEST(Propagate, badBodiesAreRefused) {
  for (int i = 1; i <= 3; ++i) {
    for (const char* bad : {"0", "-1", "-0.0", "1e-400"}) {
      expectRefused(rk4(kHeader + kRow + rowWith(i, bad)), {"line 3", "moment " + std::to_string(i), "positive"});
    }
  }
  expectRefused(rk4(kHeader + rowWith(4, "0")),
                {"line 2", "q0w, q0x, q0y, q0z: expected a quaternion other than zero"});
  // Moments of no real body are simulated.
  EXPECT_EQ(rk4(kHeader + rowWith(3, "100")).exit_code, 0);
}

TEST(Propagate, rowsOfAnotherLengthAreRefused) {
  expectRefused(rk4(kHeader + kRow + "a,1,2,3,1,0,0,0,0.01,1,0.02\n"),
                {"line 3: expected 12 cells as in the header, got 11\n"});
  expectRefused(rk4(kHeader + kRow + "a,1,2,3,1,0,0,0,0.01,1,0.02,2.5,\n"),
                {"line 3: expected 12 cells as in the header, got 13\n"});
  expectRefused(rk4(kHeader + "a\n"), {"line 2: expected 12 cells as in the header, got 1\n"});
  expectRefused(rk4(kHeader + ",,,,,,,,,,,\n"), {"line 2: mu1: expected a finite number, got \"\"\n"});
}

TEST(Propagate, quotesAreRefused) {
  expectRefused(rk4(kHeader + rowWith(0, "\"a\"")), {"line 2", "quotes"});
  expectRefused(rk4("\"id\"" + kHeader.substr(2) + kRow), {"line 1", "quotes"});
}

TEST(Propagate, badHeadersAreRefused) {
  expectRefused(rk4(""), {"line 1: expected a header"});
  expectRefused(rk4("# only\n\n"), {"line 3: expected a header"});
  expectRefused(rk4(kRow), {"line 1", "lacks id, mu1"});
  expectRefused(rk4("id,mu1,mu2,q0w,q0x,q0y,q0z,O01,O02,O03\n"), {"line 1", "lacks mu3, t"});
  expectRefused(rk4("\n" + kHeader.substr(0, kHeader.size() - 1) + ",mu2\n"),
                {"line 2", "expected every column once, got mu2 twice"});
  expectRefused(rk4("ID" + kHeader.substr(2)), {"line 1", "lacks id"});
}

std::string separatedBy(char separator, std::string text) {
  std::replace(text.begin(), text.end(), ',', separator);
  return text;
}

TEST(Propagate, semicolonsAndTabsSeparateCellsToo) {
  const Outcome by_commas = rk4(kHeader + kRow);
  for (const char separator : {';', '\t'}) {
    SCOPED_TRACE(separator);
    const Outcome outcome = rk4(separatedBy(separator, kHeader + kRow));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, by_commas.out);
    expectRefused(rk4(separatedBy(separator, kHeader + "a,1\n")),
                  {"line 2: expected 12 cells as in the header, got 2\n"});
  }
  const std::string header = separatedBy(';', kHeader);
  expectRefused(rk4(header + separatedBy(';', rowWith(1, "1|5")).replace(3, 1, ",")),
                {"line 2", "mu1: expected a decimal point and no comma, got \"1,5\""});
  expectRefused(rk4(header + "a,b" + separatedBy(';', kRow).substr(1)), {"line 2", "id: expected", "\"a,b\""});
}

TEST(Propagate, utf16IsRefusedByName) {
  const auto wide = [](const std::string& text, bool little) {
    std::string out;
    for (const char c : text) out += little ? std::string({c, '\0'}) : std::string({'\0', c});
    return out;
  };
  for (const std::string& text : {"\xFF\xFE" + wide(kHeader + kRow, true), "\xFE\xFF" + wide(kHeader + kRow, false),
                                  wide(kHeader + kRow, true), wide(kHeader + kRow, false)}) {
    expectRefused(rk4(text), {"line 1: expected UTF-8, got UTF-16"});
  }
}

TEST(Propagate, oneBadRowAndNothingComesOut) {
  std::string input = kHeader;
  for (int i = 0; i < 2000; ++i) input += kRow;
  expectRefused(rk4(input + "bad\n"), {"line 2002"});
}

TEST(Propagate, tooManyStepsAreRefused) {
  expectRefused(rk4(kHeader + kRow + rowWith(11, "1e300")), {"line 3", "t: expected at most 1e12 steps"});
  expectRefused(propagate("--method rk4 --step 1e-320", kHeader + kRow), {"line 2", "t: expected at most 1e12 steps"});
}

TEST(Propagate, badUse) {
  const std::string input = kHeader + kRow;
  expectRefused(propagate("--step 0.1", input), {"--step: expected a stepper beside it", methodNames(freeMethods()),
                                                 "got closed_form, which takes no step\n"});
  expectRefused(propagate("--method closed_form --step 0.1", input),
                {"--step: expected a stepper beside it", methodNames(freeMethods())});
  expectRefused(propagate("--method nonsense", input),
                {"--method: expected one of closed_form, " + methodNames(freeMethods()) + ", got \"nonsense\"\n"});
  expectRefused(propagate("--method nonsense --step 0.1", input), {"nonsense", "rk4"});
  expectRefused(propagate("--method rk4 --step ''", input),
                {"propagate: --step: expected a positive finite number (s), got \"\"\n"});
  expectRefused(propagate("--method rk4", input),
                {"--step: expected a positive finite number (s) for rk4, got none\n"});
  for (const std::string& bad : std::vector<std::string>{"0", "-0.1", "-0", "nan", "inf", "x", "0.1s", "''"}) {
    expectRefused(propagate("--method rk4 --step " + bad, input), {"step"});
    expectRefused(propagate("--method rk4 --step=" + bad, input), {"step"});
  }
  expectRefused(propagate("--method rk4 --step", input), {"step"});
  expectRefused(propagate("--method rk4 --step 0.1 --step 0.2", input), {"step"});
  expectRefused(propagate("--metod rk4 --step 0.1", input), {"--metod"});
  expectRefused(propagate("--method rk4 --step 0.1 file.csv", input), {"file.csv"});
  expectRefused(runProgram(shellWord(PROPAGATE) + " --method rk4 --step 0.1 < /", ""), {"cannot read"});
}

TEST(Propagate, theClosedFormIsTheDefault) {
  const Outcome outcome = propagate("", kHeader + kRow + rowWith(11, "-1e9"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(propagate("--method closed_form", kHeader + kRow + rowWith(11, "-1e9")).out, outcome.out);
  const std::vector<OutputRow> rows = parsed(outcome.out);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1].t, -1e9);
  const ClosedForm form({1, 2, 3}, Eigen::Quaterniond::Identity(), {0.01, 1, 0.02});
  for (const OutputRow& row : rows) {
    EXPECT_LE(angleBetween(row.attitude, form.at(row.t).attitude), 1e-16);
    EXPECT_EQ(row.omega, form.at(row.t).omega_principal);
  }
  EXPECT_LE(angleBetween(rows[0].attitude, parsed(rk4(kHeader + kRow).out).at(0).attitude), 1e-8);
}

TEST(Propagate, rowsThatAStepperDoesNotFollowAreNamed) {
  // The second row turns by 100 rad a step.
  const Outcome outcome = propagate("--method buss2 --step 0.01", kHeader + kRow + rowWith(9, "1e4") + kRow);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(parsed(outcome.out).size(), 3u);
  EXPECT_NE(outcome.err.find("line 3: do not trust this row: "), std::string::npos) << outcome.err;
  for (const char* line : {"line 2", "line 4"}) EXPECT_EQ(outcome.err.find(line), std::string::npos) << outcome.err;
}

TEST(Propagate, rowsThatAStepperLosesOnTheWayAreToldOf) {
  // Steps that follow each turn, and errors that add up.
  const auto err = [](const std::string& way, const std::string& row) {
    const Outcome outcome = propagate(way, kHeader + row);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.err;
  };
  const std::string rod = "rod,1.7231e-4,6.58e-6,1.7243e-4,1,0,0,0,5,60,3,";
  EXPECT_NE(err("--method lie_euler --step 0.001", rod + "10\n").find("energy drift at most"), std::string::npos);
  EXPECT_EQ(err("--method lie_euler --step 0.001", rod + "1e-3\n").find("energy drift"), std::string::npos);
  EXPECT_NE(err("--method rk4 --step 0.1", rowWith(11, "50000")).find("rad from the closed form (t = 50000 s)"),
            std::string::npos);
  EXPECT_EQ(err("", rowWith(11, "50000")), "");
}

TEST(Propagate, anAngularVelocityThatOverflowsIsNoResult) {
  // E = 1e300 J is finite, but turns a moment of 1e-320 kg·m² faster than doubles can say.
  const Outcome outcome = propagate("", kHeader + kRow + "b,1e-320,1,2,1,0,0,0,0,1e150,1e150,1\n");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("line 3: "), std::string::npos) << outcome.err;
}

TEST(Propagate, help) {
  for (const char* flag : {"--help", "-h"}) {
    const Outcome outcome = propagate(flag, "");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    for (const char* word : {"--method", "--step", "lie_euler", "q0w", "qw,qx,qy,qz", "Exit status"}) {
      EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
    }
  }
}

TEST(Propagate, stateThatOverflowsIsNoResult) {
  const Outcome outcome = rk4(kHeader + kRow + rowWith(9, "1e200"));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find("line 3"), std::string::npos) << outcome.err;
}

TEST(Propagate, aStepThatAnImplicitMethodDoesNotFindIsNoResult) {
  for (const char* name : {"midpoint", "dmv10"}) {
    const std::string arguments = std::string("--step 0.01 --method ") + name;
    EXPECT_EQ(propagate(arguments, kHeader + kRow + kRow).exit_code, 0);
    // The third row turns by 100 rad a step.
    const Outcome outcome = propagate(arguments, kHeader + kRow + kRow + rowWith(9, "1e4") + kRow);
    EXPECT_EQ(outcome.exit_code, 1) << name;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(std::string("line 4: ") + name + " finds no solution"), std::string::npos)
        << outcome.err;
    for (const char* line : {"line 2", "line 3", "line 5"})
      EXPECT_EQ(outcome.err.find(line), std::string::npos) << line;
  }
}

TEST(Propagate, outputThatCannotBeWrittenIsReported) {
  for (const char* where : {" > /dev/full", " >&-"}) {
    const Outcome outcome = propagate(std::string("--method rk4 --step 0.01") + where, kHeader + kRow);
    EXPECT_EQ(outcome.exit_code, 1) << where;
    EXPECT_NE(outcome.err.find("cannot write"), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace poinsot
