// The closed form on every row of test/data, at a tolerance that is the same for every conditioning: 2e-15 rad, and
// 2e-15 of |Ω|. One state at a time, and out of grids.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "poinsot/core/closed_form.h"
#include "row_judge.h"

namespace poinsot {
namespace {

struct File {
  const char* name;
  std::size_t rows;
};

/** The file of that name, all of it. */
std::vector<ReferenceRow> allRows(const File& file) {
  const std::vector<ReferenceRow> rows = readReferenceRows(TEST_DATA_DIR "/" + std::string(file.name));
  EXPECT_EQ(rows.size(), file.rows) << file.name;
  return rows;
}

ClosedForm closedForm(const ReferenceRow& row) {
  return {row.moments, row.attitude_0, row.omega_0};
}

struct TimeGrid {
  double t0, dt;
  Eigen::Index n;
  Eigen::Index place;  ///< where t is

  std::string text() const {
    char out[120];
    std::snprintf(out, sizeof out, "sample(%.17g, %.17g, %ld)[%ld]", t0, dt, static_cast<long>(n),
                  static_cast<long>(place));
    return out;
  }
  /** t₀ + place·dt is t, not only when rounded. */
  bool meets(double t) const {
    const double way = static_cast<double>(place) * dt;
    return std::isfinite(t0) && std::isfinite(way) && std::fma(-static_cast<double>(place), dt, way) == 0 &&
           static_cast<long double>(t0) + way == t && std::fma(static_cast<double>(place), dt, t0) == t;
  }
};

/** Grids that contain t exactly: alone, last, or anywhere; that begin near, at 0 or beyond. */
std::vector<TimeGrid> gridsThatMeet(double t) {
  const double step = t == 0 ? 0.125 : std::ldexp(1, std::ilogb(t) - 10);
  std::vector<TimeGrid> grids = {
      {t, 0, 1, 0},         {t, step, 1, 0},          {0, t / 4, 5, 4}, {0, t / 1024, 1025, 1024},
      {-t, t / 32, 65, 64}, {2 * t, -t / 64, 65, 64}, {t, 0, 3, 2}};
  for (int last = 1; last <= 18; ++last) grids.push_back({t - last * step, step, last + 1, last});
  for (int place = 0; place < 40; place += 3) grids.push_back({t + place * step, -step, 40, place});
  for (const int last : {31, 63, 100}) {  // through much of the range of exponentials
    for (double coarse = step / 8; coarse <= 16 * step; coarse *= 2) {
      grids.push_back({t - last * coarse, coarse, last + 1, last});
      grids.push_back({t + last * coarse, -coarse, last + 1, last});
    }
  }
  std::vector<TimeGrid> exact;
  for (const TimeGrid& grid : grids) {
    if (grid.meets(t)) exact.push_back(grid);
  }
  return exact;
}

void judgeSample(RowJudge& judge, const ReferenceRow& row, const ClosedForm::Samples& samples, const TimeGrid& grid) {
  const auto s = samples.row(grid.place);
  judge.judge(row, {s[0], s[1], s[2], s[3]}, {s[4], s[5], s[6]}, grid.text());
}

class ClosedFormRows : public testing::TestWithParam<File> {};

TEST_P(ClosedFormRows, at) {
  RowJudge judge;
  for (const ReferenceRow& row : allRows(GetParam())) {
    const ClosedForm::State state = closedForm(row).at(row.t);
    judge.judge(row, state.attitude, state.omega_principal, "at");
  }
  judge.print(std::string("at, ") + GetParam().name);
}

TEST_P(ClosedFormRows, sample) {
  RowJudge judge;
  for (const ReferenceRow& row : allRows(GetParam())) {
    const ClosedForm form = closedForm(row);
    const std::vector<TimeGrid> grids = gridsThatMeet(row.t);
    EXPECT_GE(grids.size(), 20u) << row.id;
    // Beyond some 1e15 turns a state is reckoned by itself, and slowly.
    const Eigen::Index longest = row.omega_0.stableNorm() * std::abs(row.t) < 1e15 ? 2000 : 20;
    for (const TimeGrid& grid : grids) {
      if (grid.n <= longest) judgeSample(judge, row, form.sample(grid.t0, grid.dt, grid.n), grid);
    }
  }
  judge.print(std::string("sample, ") + GetParam().name);
}

INSTANTIATE_TEST_SUITE_P(Files, ClosedFormRows,
                         testing::Values(File{"public.csv", 69}, File{"closed_form_rows.csv", 313}),
                         [](const auto& instance) { return instance.index == 0 ? "published" : "others"; });

TEST(ClosedFormGrids, atAThousandMillionSeconds) {
  // The rows of a grid follow one another: one body at 1e9 s + k/64 s, k = 0 … 8.
  std::vector<ReferenceRow> rows;
  for (const ReferenceRow& row : readReferenceRows(TEST_DATA_DIR "/closed_form_rows.csv")) {
    if (row.note.rfind("grid;", 0) == 0) rows.push_back(row);
  }
  ASSERT_EQ(rows.size(), 27u);
  RowJudge judge;
  for (std::size_t first = 0; first < rows.size(); first += 9) {
    const ClosedForm form = closedForm(rows[first]);
    // As they are; backwards; in the midst of long grids, at every offset from the beginning of a block.
    std::vector<TimeGrid> grids = {{1e9, 1. / 64, 9, 0}, {1e9 + 8. / 64, -1. / 64, 9, 8}};
    for (int before = 1; before <= 200; before += 7) grids.push_back({1e9 - before / 64., 1. / 64, 300, before});
    for (const TimeGrid& grid : grids) {
      const ClosedForm::Samples samples = form.sample(grid.t0, grid.dt, grid.n);
      for (int k = 0; k < 9; ++k) {
        const ReferenceRow& row = rows[first + k];
        ASSERT_EQ(row.note, rows[first].note);
        ASSERT_EQ(row.t, 1e9 + k / 64.);
        TimeGrid here = grid;
        here.place += grid.dt < 0 ? -k : k;
        judgeSample(judge, row, samples, here);
      }
    }
  }
  judge.print("grids at 1e9 s");
}

/** Runs these tests again in a process that uses no newer instructions than those named. */
void runAgainWith(const std::string& level) {
  char self[4096];
  const ssize_t length = readlink("/proc/self/exe", self, sizeof self);
  ASSERT_GT(length, 0);
  const std::string program = "'" + std::string(self, length) + "'";
  const int status = std::system(("POINSOT_SIMD=" + level + " " + program + " --gtest_filter='*ClosedForm*'").c_str());
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << level;
}

TEST(OlderProcessors, x86_64) {
  runAgainWith("baseline");
}

TEST(OlderProcessors, x86_64_v3) {
  runAgainWith("x86-64-v3");
}

// The judge can fail.

ReferenceRow someRow() {
  return readReferenceRows(TEST_DATA_DIR "/public.csv")[2];
}

/** Returns the state of the row, turned about L by an angle (world axes), its Ω longer by a relative amount. */
std::string complaintOf(const ReferenceRow& row, double turn, double part) {
  const Eigen::Matrix<long double, 3, 1> l =
      row.exact_attitude * row.moments.cast<long double>().cwiseProduct(row.exact_omega);
  const Eigen::Quaternion<long double> about_l(Eigen::AngleAxis<long double>(turn, l.normalized()));
  return complaint(row, errorsOf(row, (about_l * row.exact_attitude).cast<double>(),
                                 (row.exact_omega * (1 + static_cast<long double>(part))).cast<double>()));
}

TEST(RowJudge, acceptsTheTruthRounded) {
  EXPECT_EQ(complaintOf(someRow(), 0, 0), "");
}

TEST(RowJudge, seesATurnAboutL) {
  for (const double turn : {1e-14, -1e-14, 3e-15, 1.0, M_PI, 2 * M_PI - 1e-13}) {
    const std::string text = complaintOf(someRow(), turn, 0);
    EXPECT_NE(text.find("P003"), std::string::npos) << turn;
    EXPECT_NE(text.find("dzhanibekov"), std::string::npos) << turn;
    EXPECT_NE(text.find("attitude"), std::string::npos) << turn;
    EXPECT_EQ(text.find("omega"), std::string::npos) << turn;
  }
  EXPECT_EQ(complaintOf(someRow(), 2 * M_PI, 0), "");
}

TEST(RowJudge, seesAnotherOmega) {
  for (const double part : {1e-14, -1e-14, 3e-15, 1.0}) {
    const std::string text = complaintOf(someRow(), 0, part);
    EXPECT_NE(text.find("omega"), std::string::npos) << part;
    EXPECT_EQ(text.find("attitude"), std::string::npos) << part;
  }
}

TEST(RowJudge, seesALengthAndNaN) {
  const ReferenceRow row = someRow();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Eigen::Quaterniond q = row.attitude;
  q.coeffs() *= 1 + 2e-15;
  EXPECT_NE(complaint(row, errorsOf(row, q, row.omega)).find("length"), std::string::npos);
  q = row.attitude;
  q.x() = nan;
  EXPECT_NE(complaint(row, errorsOf(row, q, row.omega)).find("attitude"), std::string::npos);
  EXPECT_NE(complaint(row, errorsOf(row, row.attitude, {nan, 0, 0})).find("omega"), std::string::npos);
}

TEST(RowJudge, measuresTinyAndHugeRatesRelatively) {
  for (const double size : {1e-200, 1e150, 1e-300}) {
    ReferenceRow row = someRow();
    row.exact_omega *= size / static_cast<double>(row.exact_omega.norm());
    EXPECT_EQ(complaintOf(row, 0, 0), "") << size;
    EXPECT_NE(complaintOf(row, 0, 1e-14).find("omega"), std::string::npos) << size;
  }
}

}  // namespace
}  // namespace poinsot
