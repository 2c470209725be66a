#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "poinsot/scene/reader.h"

/** What the tests of the scene reader share: writing a scene down, and looking at the message when it is refused. */
namespace scene_text {

/** A file that is gone at the end of its scope. */
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text) {
    static int count = 0;
    path_ = testing::TempDir() + "poinsot_scene_" + std::to_string(getpid()) + "_" + std::to_string(count++) + ".yaml";
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~TemporaryFile() { std::remove(path_.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

inline poinsot::scene::Scene read(const std::string& text) {
  const TemporaryFile file(text);
  return poinsot::scene::readFile(file.path());
}

/** A scene of one body, "brick", whose keys are these lines; inertia and angular_velocity are put in if left out. */
inline std::string body(const std::vector<std::string>& lines) {
  bool has_inertia = false, has_velocity = false;
  std::string text = "bodies:\n  - name: brick\n";
  for (const std::string& line : lines) {
    has_inertia |= line.rfind("inertia:", 0) == 0 || line.rfind("shape:", 0) == 0;
    has_velocity |= line.rfind("angular_velocity:", 0) == 0;
    text += "    " + line + "\n";
  }
  if (!has_inertia) text += "    inertia: [1, 2, 3]\n";
  if (!has_velocity) text += "    angular_velocity: [0, 1, 0]\n";
  return text;
}

/** The line of `body(...)` on which its first given key stands. */
constexpr int kFirstLine = 3;

inline poinsot::scene::Body readBody(const std::vector<std::string>& lines) {
  return read(body(lines)).bodies.at(0);
}

/**
 * Expects a refusal "file:line: place: expected X, got Y" (line 0: no line) that holds every one of the pieces; a piece
 * that ends in '$' must stand at its end.
 */
inline void expectRefused(const std::string& text, int line, const std::string& place,
                          const std::vector<std::string>& pieces) {
  const TemporaryFile file(text);
  try {
    poinsot::scene::readFile(file.path());
  } catch (const poinsot::scene::Error& error) {
    const std::string what = error.what();
    const std::string head =
        file.path() + (line ? ":" + std::to_string(line) : "") + ": " + (place.empty() ? "" : place + ": ");
    EXPECT_EQ(what.rfind(head + "expected ", 0), 0u) << what;
    EXPECT_NE(what.find(", got "), std::string::npos) << what;
    for (const std::string& piece : pieces) {
      EXPECT_NE((what + "$").find(piece), std::string::npos) << piece << "\n" << what;
    }
    return;
  }
  ADD_FAILURE() << "accepted:\n" << text;
}

/** expectRefused for one key of the body "brick". */
inline void expectKeyRefused(const std::string& key_and_value, const std::string& place_in_body,
                             const std::vector<std::string>& pieces) {
  SCOPED_TRACE(key_and_value);
  expectRefused(body({key_and_value}), kFirstLine, "bodies[0] \"brick\"" + place_in_body, pieces);
}

}  // namespace scene_text
