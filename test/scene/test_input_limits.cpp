// Whatever the path of a scene leads to, and whatever stands there, reading it ends soon and says what is wrong.
// All reading is done in a child process with limits, so that a reader that hangs fails the test instead of stopping
// it.
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <functional>
#include <iterator>
#include <random>

#include "scene_text.h"

namespace {

namespace fs = std::filesystem;

using scene_text::TemporaryFile;

const std::string kExpected = " expected a regular file of at most 4194304 bytes, got ";
const std::string kBody = "{name: a, inertia: [1, 2, 3], angular_velocity: [0, 1, 0]}";

/** What `act` gives when a child process does it, or which signal ended the child: 20 s of CPU, 60 s, 2 GiB. */
std::string inAChild(const std::function<std::string()>& act) {
  int ends[2];
  if (pipe(ends) != 0) return "no pipe";
  const pid_t child = fork();
  if (child == 0) {
    const rlimit cpu{20, 20}, memory{rlim_t{2} << 30, rlim_t{2} << 30}, core{0, 0};
    setrlimit(RLIMIT_CPU, &cpu);
    setrlimit(RLIMIT_AS, &memory);
    setrlimit(RLIMIT_CORE, &core);
    alarm(60);
    std::string said;
    try {
      said = act();
    } catch (const std::exception& error) {
      said = std::string("not a refusal: ") + error.what();
    }
    const bool written = write(ends[1], said.data(), said.size()) == static_cast<ssize_t>(said.size());
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  std::string said;
  char buffer[4096];
  for (ssize_t count; (count = read(ends[0], buffer, sizeof buffer)) > 0;) said.append(buffer, count);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? std::string("the reader was ended: ") + strsignal(WTERMSIG(status)) : said;
}

/** The refusal, without the path with which it must begin; or "accepted". */
std::string messageOf(const std::string& path) {
  const std::string said = inAChild([&]() -> std::string {
    try {
      poinsot::scene::readFile(path);
    } catch (const poinsot::scene::Error& error) {
      return error.what();
    }
    return "accepted";
  });
  return said.rfind(path + ":", 0) == 0 ? said.substr(path.size() + 1) : said;
}

std::string messageOfText(const std::string& text) {
  return messageOf(TemporaryFile(text).path());
}

/** A directory that is gone with its object. */
class Directory {
 public:
  Directory() { fs::create_directory(path); }
  ~Directory() { fs::remove_all(path); }
  const std::string path = testing::TempDir() + "poinsot_input_limits_" + std::to_string(getpid());
};

std::string contentOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST(Text, OutsideOfTheDocumentIsRefusedWithItsLine) {
  const auto outside = [](const std::string& shown) {
    return ": expected one YAML document, got \"" + shown + "\" outside of it";
  };
  EXPECT_EQ(messageOfText(","), "1" + outside(","));
  EXPECT_EQ(messageOfText("[a], b"), "1" + outside(", b"));
  EXPECT_EQ(messageOfText("# bodies that spin\n, and how they do\nrate: 60\n"), "2" + outside(", and how they do"));
  EXPECT_EQ(messageOfText("\n\n--- ,\n"), "3" + outside(","));
  EXPECT_EQ(messageOfText("{bodies: [" + kBody + "]}\n, b\n"), "2" + outside(", b"));
  EXPECT_EQ(messageOfText("bodies: [" + kBody + "]\n...\nrate: 60\n"), "3" + outside("rate: 60"));
}

TEST(Text, OfASecondDocumentIsRefusedWithItsLine) {
  const std::string second = ": expected one YAML document, got a second";
  EXPECT_EQ(messageOfText("bodies: [" + kBody + "]\n---\nbodies: []\n---\n"), "2" + second);
  EXPECT_EQ(messageOfText("--- {bodies: [" + kBody + "]}\n--- ,\n"), "2" + second);
  EXPECT_EQ(messageOfText("bodies: [" + kBody + "]\n...\n---\n"), "3" + second);
}

TEST(Text, OfAnyIndicatorsIsReadToAnEnd) {
  const std::string alphabet = ",[]{}:-#&*!|>'\"%@`\n a?.~<";
  const TemporaryFile file("");
  const auto refused = [&](const std::string& text) {
    std::remove(file.path().c_str());  // file systems flush a file that is written anew in place, which takes long
    std::ofstream(file.path(), std::ios::binary) << text;
    try {
      poinsot::scene::readFile(file.path());
    } catch (const poinsot::scene::Error& error) {
      return std::string(error.what()).rfind(file.path() + ":", 0) == 0;
    }
    return false;  // none of these is a scene
  };
  const std::string said = inAChild([&]() -> std::string {
    for (const char a : alphabet) {
      if (!refused({a})) return "accepted";
      for (const char b : alphabet) {
        if (!refused({a, b})) return "accepted";
      }
    }
    std::mt19937 draw(1);
    for (int i = 0; i < 4000; ++i) {
      std::string text;
      for (std::size_t left = 4 + draw() % 40; left > 0; --left) text += alphabet[draw() % alphabet.size()];
      if (!refused(text)) return "accepted";
    }
    return "all refused";
  });
  EXPECT_EQ(said, "all refused") << "at the text:\n" << contentOf(file.path());
}

TEST(Text, OfTooManyValuesIsRefused) {
  const std::string expected =
      ": expected at most 500000 values and keys, those behind an alias counted at each use, got more";
  std::string nulls = "rate: 60\nbodies: [";
  for (int i = 0; i < 500000; ++i) nulls += ",";
  EXPECT_EQ(messageOfText(nulls + "]\n"), "2" + expected);

  // 4,000 bodies under the same 4,000 torques: 300 kB of text, 16 million torques.
  const std::string torque = "{type: constant_torque, frame: body, torque: [0, 0, 1]}";
  std::string bodies = "bodies:\n  - {name: a0, inertia: [1, 2, 3], angular_velocity: [0, 1, 0], effects: &all [";
  for (int i = 0; i < 4000; ++i) bodies += (i ? ", *one" : "&one " + torque);
  bodies += "]}\n";
  for (int i = 1; i < 4000; ++i) {
    bodies +=
        "  - {name: a" + std::to_string(i) + ", inertia: [1, 2, 3], angular_velocity: [0, 1, 0], effects: *all}\n";
  }
  // 40,000 values and keys in the first body's effects, so in the thirteenth the limit is passed.
  EXPECT_EQ(messageOfText(bodies), "14" + expected);
}

TEST(Text, NestedTooDeeplyIsRefused) {
  const std::string refusal = ": expected at most 100 lists and maps within each other, got more";
  EXPECT_EQ(messageOfText(std::string(100, '[') + std::string(100, ']')),
            "1: expected a map with the keys rate, bodies, got a list of 1");
  EXPECT_EQ(messageOfText(std::string(101, '[') + std::string(101, ']')), "1" + refusal);
  EXPECT_EQ(messageOfText("rate: 60\nbodies: " + std::string(100000, '[')), "2" + refusal);
}

TEST(Text, OfManyKeysIsReadInGoodTime) {
  std::string text;
  for (int i = 0; i < 240000; ++i) text += "key_" + std::to_string(i) + ": 1\n";
  EXPECT_EQ(messageOfText(text), "1: key_0: expected one of the keys rate, loop, bodies, drawings, got \"key_0\"");
}

TEST(Path, ToAnythingButARegularFileIsRefused) {
  const Directory directory;
  EXPECT_EQ(messageOf(directory.path), kExpected + "a directory");
  const std::string fifo = directory.path + "/fifo.yaml";
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  EXPECT_EQ(messageOf(fifo), kExpected + "a FIFO (named pipe)");
  const std::string link = directory.path + "/link.yaml";
  fs::create_symlink(fifo, link);
  EXPECT_EQ(messageOf(link), kExpected + "a FIFO (named pipe)");
  EXPECT_EQ(messageOf("/dev/zero"), kExpected + "a character device");
  EXPECT_EQ(messageOf("/dev/null"), kExpected + "a character device");
}

TEST(Path, ThatIsALinkToARegularFileIsFine) {
  const Directory directory;
  const TemporaryFile scene("bodies: [" + kBody + "]\n");
  const std::string link = directory.path + "/link.yaml";
  fs::create_symlink(scene.path(), link);
  EXPECT_EQ(messageOf(link), "accepted");
}

TEST(Path, ToAFileThatIsTooLargeIsRefused) {
  const std::string scene = "bodies: [" + kBody + "]\n#";
  const TemporaryFile file(scene + std::string(4194304 - scene.size(), '#'));
  EXPECT_EQ(messageOf(file.path()), "accepted");
  fs::resize_file(file.path(), 4194305);
  EXPECT_EQ(messageOf(file.path()), kExpected + "4194305 bytes");
  fs::resize_file(file.path(), 1ull << 40);  // a hole
  EXPECT_EQ(messageOf(file.path()), kExpected + "1099511627776 bytes");
}

TEST(Path, ToAFileThatHoldsMoreThanItsSizeIsReadToTheLimit) {
  const std::string endless = "/proc/self/pagemap";  // a regular file of size 0, of some 10^11 bytes
  if (access(endless.c_str(), R_OK) != 0) GTEST_SKIP() << "this kernel has no " << endless;
  EXPECT_EQ(messageOf(endless), kExpected + "a larger one");
}
