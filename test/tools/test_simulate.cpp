// The program as its users meet it: a process with arguments, files, stdout, stderr, signals and an exit code.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "reference_rows.h"
#include "row_judge.h"
#include "run_program.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

const std::string kHeader = "body,t,qw,qx,qy,qz,O1,O2,O3,bx,by,bz";
const std::string kTop = "bodies:\n  - {name: top, inertia: [1, 2, 3], angular_velocity: [0.01, 1, 0.02]}\n";
const std::string kThree =
    "rate: 10\n"
    "bodies:\n"
    "  - {name: thrown, inertia: [1, 2, 3], angular_velocity: [0.3, 1, -0.2],\n"
    "     effects: [{type: translation, position: [1, 2, 3], velocity: [0, 1, 0], acceleration: [0, 0, -10]}]}\n"
    "  - {name: stepped, inertia: [3, 2, 1], angular_velocity: [0.1, 1, 0.1], method: rk4, step: 0.013,\n"
    "     effects: [{type: translation, position: [5, 0, 0]}]}\n"
    "  - {name: tensor, inertia: [[2, 0.1, 0], [0.1, 3, 0.2], [0, 0.2, 4]], angular_velocity: [1, 0.2, 0.1],\n"
    "     effects: [{type: translation, position: [9, 0, 0]}]}\n";

std::string contentOf(const fs::path& path) {
  std::ostringstream out;
  out << std::ifstream(path, std::ios::binary).rdbuf();
  return out.str();
}

struct Row {
  std::string body;
  double t;
  Eigen::Quaterniond attitude;
  Eigen::Vector3d omega, position;
  std::string text;
};

std::vector<Row> parsed(const std::string& csv) {
  std::istringstream in(csv);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, kHeader);
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    std::istringstream cells(line);
    std::string body, cell;
    std::getline(cells, body, ',');
    std::vector<double> v;
    while (std::getline(cells, cell, ',')) v.push_back(std::strtod(cell.c_str(), nullptr));
    if (v.size() != 11) {
      ADD_FAILURE() << line;
      continue;
    }
    rows.push_back({body, v[0], {v[1], v[2], v[3], v[4]}, {v[5], v[6], v[7]}, {v[8], v[9], v[10]}, line});
  }
  return rows;
}

std::vector<double> timesOf(const std::vector<Row>& rows, const std::string& body) {
  std::vector<double> times;
  for (const Row& row : rows) {
    if (row.body == body) times.push_back(row.t);
  }
  return times;
}

/** A directory of its own, with scenes and what comes of them. */
class Simulate : public testing::Test {
 protected:
  void SetUp() override {
    char name[] = "/tmp/poinsot_simulate.XXXXXX";
    ASSERT_NE(mkdtemp(name), nullptr);
    directory_ = name;
  }
  void TearDown() override { fs::remove_all(directory_); }

  fs::path path(const std::string& name) const { return directory_ / name; }

  fs::path scene(const std::string& text) const {
    std::ofstream(path("scene.yaml")) << text;
    return path("scene.yaml");
  }

  /** @param before comes before the program on the command line. */
  Outcome simulate(const std::string& text, const std::string& arguments, const std::string& before = "") const {
    return runProgram("cd " + directory_.string() + " && " + before + " " + shellWord(SIMULATE) + " " +
                          scene(text).string() + " " + arguments,
                      "");
  }

  std::vector<Row> rowsOf(const std::string& text, const std::string& arguments) const {
    const Outcome outcome = simulate(text, arguments + " --csv -");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return parsed(outcome.out);
  }

  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(directory_)) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

  void expectRefused(const std::string& text, const std::string& arguments, int code,
                     const std::vector<std::string>& mentioned, const std::string& before = "") {
    const auto there = files();
    const Outcome outcome = simulate(text, arguments, before);
    EXPECT_EQ(outcome.exit_code, code) << arguments << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments;
    for (const std::string& word : mentioned) {
      EXPECT_NE(outcome.err.find(word), std::string::npos) << "\"" << word << "\" in: " << outcome.err;
    }
    auto expected = there;
    if (!std::count(there.begin(), there.end(), "scene.yaml")) expected.push_back("scene.yaml");
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(files(), expected) << arguments;
  }

  fs::path directory_;
};

TEST_F(Simulate, aRowForEachBodyAndTimeTheLastAtExactlyTheDuration) {
  const std::vector<Row> rows = rowsOf(kThree, "--duration 1.234567");
  for (const char* body : {"thrown", "stepped", "tensor"}) {
    const std::vector<double> times = timesOf(rows, body);
    ASSERT_EQ(times.size(), 14u) << body;
    for (int k = 0; k < 13; ++k) EXPECT_EQ(times[k], k / 10.0);
    EXPECT_EQ(times.back(), 1.234567);
  }
  EXPECT_EQ(rows.size(), 3 * 14u);
}

TEST_F(Simulate, aDurationOfWholePeriodsAddsNoRow) {
  for (const auto& [duration, rate, count] :
       std::vector<std::tuple<std::string, std::string, std::size_t>>{{"0.7", "10", 8},
                                                                      {"0.3", "10", 4},
                                                                      {"10", "60", 601},
                                                                      {"1e-3", "1e4", 11},
                                                                      {"100", "0.1", 11},
                                                                      {"3.3", "0.30303030303030304", 2},
                                                                      {"49", "0.020408163265306121", 2},
                                                                      {"0.001", "10", 2},
                                                                      {"1e5", "3.7", 370001}}) {
    const std::vector<double> times = timesOf(rowsOf(kTop, "--duration " + duration + " --rate " + rate), "top");
    EXPECT_EQ(times.size(), count) << duration << " s at " << rate;
    EXPECT_EQ(times.front(), 0);
    EXPECT_EQ(times.back(), std::stod(duration));
    EXPECT_TRUE(std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) == times.end()) << duration;
  }
}

TEST_F(Simulate, theRateIsTheOptionsTheScenesOrSixty) {
  EXPECT_EQ(rowsOf(kTop, "--duration 1").size(), 61u);
  EXPECT_EQ(rowsOf("rate: 20\n" + kTop, "--duration 1").size(), 21u);
  EXPECT_EQ(rowsOf("rate: 20\n" + kTop, "--duration 1 --rate 5").size(), 6u);
}

TEST_F(Simulate, seventeenDigitsBringEveryBitBack) {
  for (const Row& row : rowsOf(kThree, "--duration 3.21")) {
    char text[500];
    std::snprintf(text, sizeof text, "%s,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g",
                  row.body.c_str(), row.t, row.attitude.w(), row.attitude.x(), row.attitude.y(), row.attitude.z(),
                  row.omega.x(), row.omega.y(), row.omega.z(), row.position.x(), row.position.y(), row.position.z());
    EXPECT_EQ(row.text, text);
  }
}

/** The cells of a line but for the first, the body's name. */
std::vector<double> numbersOf(const std::string& line) {
  std::istringstream cells(line);
  std::string cell;
  std::getline(cells, cell, ',');
  std::vector<double> out;
  while (std::getline(cells, cell, ',')) out.push_back(std::strtod(cell.c_str(), nullptr));
  return out;
}

TEST_F(Simulate, moreColumns) {
  const std::string text =
      "bodies:\n"
      "  - {name: exact, inertia: [1, 2, 3], attitude: [1, 2, 3, 4], angular_velocity: [0.3, 1, -0.2]}\n"
      "  - {name: stepped, inertia: [1, 2, 3], attitude: [1, 2, 3, 4], angular_velocity: [0.3, 1, -0.2], method: "
      "lie_euler, step: 0.01, effects: [{type: translation, position: [9, 0, 0]}]}\n"
      "  - {name: top, inertia: [1, 2, 3], angular_velocity: [0.3, 1, 5], effects: [{type: gravity_torque, mass: 1, "
      "centre_of_mass: [0, 0, 0.1]}]}\n";
  const Outcome outcome = simulate(text, "--duration 3 --rate 10 --csv - --columns states,energy,errors");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream in(outcome.out);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, kHeader + ",E,Lx,Ly,Lz,attitude_error,energy_drift");
  std::vector<std::vector<double>> exact, stepped;
  int rows = 0;
  for (; std::getline(in, line); ++rows) {
    const std::vector<double> v = numbersOf(line);
    ASSERT_EQ(v.size(), 17u) << line;
    const Eigen::Vector3d omega(v[5], v[6], v[7]), moments(1, 2, 3);
    EXPECT_NEAR(v[11], 0.5 * omega.dot(moments.cwiseProduct(omega)), 1e-15 * v[11]);
    const Eigen::Vector3d momentum = Eigen::Quaterniond(v[1], v[2], v[3], v[4]) * moments.cwiseProduct(omega);
    EXPECT_LT((Eigen::Vector3d(v[12], v[13], v[14]) - momentum).norm(), 2e-15 * momentum.norm());
    if (line.rfind("exact", 0) == 0) exact.push_back(v);
    if (line.rfind("stepped", 0) == 0) stepped.push_back(v);
    if (line.rfind("top", 0) == 0) {
      EXPECT_TRUE(std::isnan(v[15])) << line;
    }
  }
  EXPECT_EQ(rows, 3 * 31);
  ASSERT_EQ(exact.size(), stepped.size());
  double worst = 0;
  for (std::size_t k = 0; k < exact.size(); ++k) {
    EXPECT_EQ(exact[k][15], 0);
    const auto attitude = [](const std::vector<double>& v) { return Eigen::Quaterniond(v[1], v[2], v[3], v[4]); };
    const double apart = attitude(exact[k]).angularDistance(attitude(stepped[k]));
    EXPECT_NEAR(stepped[k][15], apart, 1e-7);
    EXPECT_NEAR(stepped[k][16], stepped[k][11] / stepped[0][11] - 1, 1e-14);
    worst = std::max(worst, stepped[k][15]);
  }
  EXPECT_GT(worst, 1e-4);
  // stderr says the worst of the body that is stepped, and of no other.
  char said[96];
  std::snprintf(said, sizeof said, "body stepped: lie_euler with a step of 0.01 s: at most %.3g rad", worst);
  EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("body exact"), std::string::npos);
  EXPECT_NE(simulate(text, "--duration 3 --rate 10 --no-markers --bag a.bag").err.find(said), std::string::npos);

  const std::string plain = simulate(text, "--duration 3 --rate 10 --csv -").out;
  EXPECT_EQ(simulate(text, "--duration 3 --rate 10 --csv - --columns states").out, plain);
  const std::string energy = simulate(text, "--duration 3 --rate 10 --csv - --columns energy").out;
  EXPECT_EQ(energy.substr(0, energy.find('\n')), kHeader + ",E,Lx,Ly,Lz");
  expectRefused(kTop, "--duration 3 --csv a.csv --columns states,speed", 2,
                {"--columns: expected states, energy and errors", ", got \"speed\"\n"});
}

TEST_F(Simulate, theSameBytesEveryTime) {
  const std::string accurate =
      "bodies:\n  - {name: top, inertia: [1, 2, 3], angular_velocity: [0.3, 1, 0.2], method: stepper, accuracy: "
      "1e-7}\n";
  for (const std::string& text : {kThree, accurate}) {
    scene(text);
    for (const char* run : {"a", "b"}) {
      const std::string to = std::string(" --csv ") + run + ".csv --bag " + run + ".bag";
      ASSERT_EQ(simulate(text, "--duration 3.21 --rate 50" + to,
                         std::string("LC_ALL=") + (run[0] == 'a' ? "C" : "de_DE.UTF-8"))
                    .exit_code,
                0);
    }
    EXPECT_EQ(contentOf(path("a.csv")), contentOf(path("b.csv")));
    EXPECT_TRUE(contentOf(path("a.bag")) == contentOf(path("b.bag")));
    EXPECT_GT(contentOf(path("a.csv")).size(), 1000u);
    EXPECT_EQ(contentOf(path("a.csv")), simulate(text, "--duration 3.21 --rate 50 --csv -").out);
  }
}

TEST_F(Simulate, referenceStates) {
  // Rows of 25 digits whose moments and starts a scene can give; t is the duration. The scene takes any attitude.
  int judged = 0;
  RowJudge judge;
  for (const ReferenceRow& row : readReferenceRows(TEST_DATA_DIR "/public.csv")) {
    // A scene refuses spins whose energy doubles do not hold in full precision.
    if (!(row.t > 0) || (row.omega_0.norm() > 0 && row.omega_0.norm() < 1e-150)) continue;
    std::ostringstream text;
    text.precision(17);
    text << "bodies:\n  - {name: body, inertia: [" << row.moments[0] << ", " << row.moments[1] << ", " << row.moments[2]
         << "], attitude: [" << row.attitude_0.w() << ", " << row.attitude_0.x() << ", " << row.attitude_0.y() << ", "
         << row.attitude_0.z() << "], angular_velocity: [" << row.omega_0[0] << ", " << row.omega_0[1] << ", "
         << row.omega_0[2] << "]}\n";
    std::ostringstream arguments;
    arguments.precision(17);
    arguments << "--duration " << row.t << " --rate " << 3 / row.t;
    const std::vector<Row> rows = rowsOf(text.str(), arguments.str());
    ASSERT_EQ(rows.size(), 4u) << row.id;
    judge.judge(row, rows.back().attitude, rows.back().omega, "simulate");
    ++judged;
  }
  EXPECT_GE(judged, 50);
  judge.print("simulate, public.csv");
}

TEST_F(Simulate, theBodyThatIsThrownFliesAsItShould) {
  int seen = 0;
  for (const Row& row : rowsOf(kThree, "--duration 2")) {
    if (row.body != "thrown") continue;
    const Eigen::Vector3d expected(1, 2 + row.t, 3 - 5 * row.t * row.t);
    EXPECT_LE((row.position - expected).norm(), 1e-14) << row.t;
    ++seen;
  }
  EXPECT_EQ(seen, 21);
}

TEST_F(Simulate, anAccuracyHoldsForTheDuration) {
  const auto body = [](const std::string& keys) {
    return "bodies:\n  - {name: top, inertia: [1, 2, 3], angular_velocity: [0.3, 1, 0.2], " + keys + "}\n";
  };
  const auto said = [&](const std::string& keys) {
    const Outcome outcome = simulate(body(keys), "--duration 20 --csv -");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.err;
  };
  EXPECT_NE(said("method: stepper, accuracy: 1e-6").find("over 20 s"), std::string::npos);
  EXPECT_NE(said("method: stepper, accuracy: 1e-6, horizon: 5").find("over 20 s"), std::string::npos);
  EXPECT_NE(said("method: stepper, accuracy: 1e-6, horizon: 50").find("over 50 s"), std::string::npos);

  const auto exact = rowsOf(body("method: closed_form"), "--duration 20");
  const auto stepped = rowsOf(body("method: stepper, accuracy: 1e-6"), "--duration 20");
  ASSERT_EQ(exact.size(), stepped.size());
  double worst = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    worst = std::max(worst, exact[i].attitude.angularDistance(stepped[i].attitude));
  }
  EXPECT_LE(worst, 1e-6 + 1e-7);
  EXPECT_GT(worst, 1e-8);  // a stepper it was
  expectRefused(body("method: rk4, accuracy: 1e-15"), "--duration 20 --csv a.csv", 2, {"accuracy", "rk4"});
}

TEST_F(Simulate, badScenesAndBadUse) {
  expectRefused("bodies: []\n", "--duration 1 --csv a.csv", 2, {"scene.yaml:1", "got an empty list"});
  expectRefused(kTop + "    mass: 3\n", "--duration 1 --csv a.csv", 2, {"scene.yaml:"});
  expectRefused(kTop, "--duration 1", 2, {"--csv", "--bag"});
  expectRefused(kTop, "--csv a.csv", 2, {"--duration"});
  for (const char* bad : {"0", "-1", "nan", "inf", "x", "1s", "1e999", "''", "-0"}) {
    expectRefused(kTop, std::string("--csv a.csv --duration ") + bad, 2,
                  {"simulate: --duration: expected a positive finite number (s), got"});
    expectRefused(kTop, std::string("--csv a.csv --duration 1 --rate ") + bad, 2,
                  {"simulate: --rate: expected a positive finite number (Hz), got"});
  }
  expectRefused(kTop, "--csv a.csv --duration 1e300", 2, {"states", "1e+12"});
  expectRefused(kTop, "--csv a.csv --duration 1 --rate 1e300", 2, {"states", "1e+12"});
  expectRefused(kTop, "--bag a.bag --duration 1e10 --rate 0.001", 2, {"stamps"});
  expectRefused(kTop, "--bag a.bag --duration 1e-6 --rate 1e9", 2, {"stamps"});
  expectRefused(kTop, "--csv a --bag ./a --duration 1", 2,
                {"--bag: expected a file other than that of --csv, got ./a\n"});
  expectRefused(kTop, "--csv scene.yaml --duration 1", 2, {"--csv: expected a file other than the scene"});
  expectRefused(kTop, "--bag - --duration 1", 2, {"a bag needs a file"});
  expectRefused(kTop, "--csv '' --duration 1", 2, {"--csv"});
  expectRefused(kTop, "--cvs a --duration 1", 2, {"--cvs"});
  expectRefused("bodies:\n  - {name: top, inertia: [1, 2, 3], angular_velocity: [1, 0, 0], method: rk4, step: 1e-5}\n",
                "--csv a.csv --duration 1e9 --rate 0.001", 2, {"top", "rk4", "steps"});
  const Outcome none = runProgram(shellWord(SIMULATE) + " /nowhere.yaml --duration 1 --csv -", "");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_NE(none.err.find("/nowhere.yaml"), std::string::npos);
}

TEST_F(Simulate, help) {
  const Outcome outcome = runProgram(shellWord(SIMULATE) + " --help", "");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.err, "");
  for (const std::string& word : {kHeader, std::string("--duration"), std::string("--no-markers")}) {
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
  }
}

TEST_F(Simulate, aStateThatIsOutOfRangeIsNoResult) {
  expectRefused(
      "bodies:\n  - {name: far, inertia: [1, 2, 3], angular_velocity: [0, 1, 0], effects: [{type: translation, "
      "velocity: [1e308, 0, 0]}]}\n",
      "--duration 10 --csv a.csv", 1, {"body far under closed_form at t = "});
}

TEST_F(Simulate, whatCannotBeWrittenIsSaidAndNothingIsLeft) {
  for (const char* option : {"--csv ", "--bag "}) {
    expectRefused(kTop, std::string(option) + "nowhere/a --duration 1", 1, {"nowhere/a", "No such file"});
    expectRefused(kTop, std::string(option) + ". --duration 1", 1, {"Is a directory"});
    expectRefused(kTop, std::string(option) + "/dev/full --duration 1", 1, {"/dev/full"});
    // A limit on the size of files stands for a disk that is full.
    for (const char* blocks : {"1", "7", "100"}) {
      expectRefused(kTop, std::string(option) + "a --duration 1000", 1, {"cannot write a: ", "File too large"},
                    std::string("ulimit -f ") + blocks + ";");
    }
  }
  expectRefused(kTop, "--csv - --duration 10 > /dev/full", 1, {"No space left"});
  expectRefused(kTop, "--csv - --duration 10 >&-", 1, {"standard output"});
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(Simulate, aDiskThatIsFull) {
  const Outcome can = runProgram("unshare -m mount -t tmpfs none " + directory_.string(), "");
  if (can.exit_code != 0) GTEST_SKIP() << "no file system can be mounted here: " << can.err;
  for (const char* option : {"--csv", "--bag"}) {
    for (const char* size : {"4k", "100k", "300k"}) {
      const std::string script = "mount -t tmpfs -o size=" + std::string(size) +
                                 " none disk && cd disk && echo old > a && " + shellWord(SIMULATE) +
                                 " ../scene.yaml --duration 100 " + option + " a; echo $?; ls -A; cat a";
      fs::create_directory(path("disk"));
      scene(kTop);
      const Outcome outcome = runProgram("cd " + directory_.string() + " && unshare -m sh -c '" + script + "'", "");
      EXPECT_EQ(outcome.out, "1\na\nold\n") << option << " " << size;
      EXPECT_NE(outcome.err.find("cannot write a: No space left on device"), std::string::npos) << outcome.err;
    }
  }
}

TEST_F(Simulate, whatStoodThereStaysUntilTheNewIsComplete) {
  // A list of libraries is split at blanks, which the library's own path may hold.
  const std::string library = "/tmp/poinsot_failing_disk." + std::to_string(getpid()) + ".so";
  fs::create_symlink(FAILING_DISK, library);
  const std::string preload = "LD_PRELOAD=" + library;
  for (const char* option : {"--csv a", "--bag a", "--csv a --bag b", "--bag a --csv b"}) {
    for (const char* call : {"fsync", "close", "rename"}) {
      std::ofstream(path("a")) << "old\n";
      expectRefused(kTop, std::string(option) + " --duration 1", 1, {"cannot write "},
                    std::string("FAILING_CALL=") + call + " " + preload);
      EXPECT_EQ(contentOf(path("a")), "old\n") << option << " " << call;
    }
    EXPECT_EQ(simulate(kTop, std::string(option) + " --duration 1", preload).exit_code, 0);
    EXPECT_GT(fs::file_size(path("a")), 1000u);
    fs::remove(path("b"));
  }
  fs::remove(library);
}

TEST_F(Simulate, aFileKeepsItsModeAndALinkItsPlace) {
  std::ofstream(path("real")) << "old\n";
  fs::permissions(path("real"), fs::perms::owner_all);
  fs::create_symlink("real", path("link"));
  EXPECT_EQ(simulate(kTop, "--csv link --duration 1").exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(parsed(contentOf(path("real"))).size(), 61u);
  EXPECT_EQ(fs::status(path("real")).permissions(), fs::perms::owner_all);
  EXPECT_EQ(simulate(kTop, "--csv new --duration 1", "umask 027;").exit_code, 0);
  EXPECT_EQ(fs::status(path("new")).permissions(), fs::perms(0640));
  EXPECT_EQ(files(), (std::vector<std::string>{"link", "new", "real", "scene.yaml"}));
}

TEST_F(Simulate, pipesAreWrittenTo) {
  const Outcome outcome = simulate(kTop, "--csv pipe --duration 1 & cat pipe; wait", "mkfifo pipe;");
  EXPECT_EQ(parsed(outcome.out).size(), 61u) << outcome.err;
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
  const Outcome closed = simulate(kTop, "--csv - --bag a.bag --duration 1000 2> err | head -n 1");
  EXPECT_EQ(closed.out, kHeader + "\n");
  EXPECT_NE(contentOf(path("err")).find("standard output: Broken pipe"), std::string::npos);
  EXPECT_EQ(files(), (std::vector<std::string>{"err", "pipe", "scene.yaml"}));
}

TEST_F(Simulate, aSignalLeavesNothing) {
  const std::string file = scene(kTop).string();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    for (const char* option : {"--csv", "--bag"}) {
      std::ofstream(path("a")) << "old\n";
      const pid_t child = fork();
      if (child == 0) {
        if (chdir(directory_.c_str()) != 0) _exit(99);
        ::signal(signal, SIG_DFL);
        execl(SIMULATE, SIMULATE, file.c_str(), "--duration", "1e9", option, "a", nullptr);
        _exit(98);
      }
      // Until it writes; a minute's patience.
      bool writes = false;
      for (int i = 0; i < 6000 && !writes; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        for (const auto& entry : fs::directory_iterator(directory_)) {
          std::error_code gone;
          writes |= entry.path().extension() == ".tmp" && entry.file_size(gone) > 20000;
        }
      }
      EXPECT_TRUE(writes);
      kill(child, signal);
      int status = 0;
      waitpid(child, &status, 0);
      EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
      EXPECT_EQ(files(), (std::vector<std::string>{"a", "scene.yaml"})) << option;
      EXPECT_EQ(contentOf(path("a")), "old\n");
    }
  }
}

TEST_F(Simulate, theBarIsForTerminalsOnly) {
  EXPECT_EQ(simulate(kTop, "--csv a.csv --duration 10").err, "");
  const Outcome terminal = simulate(kTop, "--csv a.csv --duration 10' /dev/null", "script -qec '");
  EXPECT_EQ(terminal.exit_code, 0) << terminal.err;
  EXPECT_NE(terminal.out.find("100%"), std::string::npos) << terminal.out;
  EXPECT_NE(terminal.out.find("*****"), std::string::npos) << terminal.out;
}

}  // namespace
}  // namespace poinsot
