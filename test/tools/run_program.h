#pragma once

#include <string>
#include <vector>

namespace poinsot {

struct Outcome {
  int exit_code = -1;  ///< 128 + signal when killed by one
  std::string out, err;
};

/** A path as one word of a shell command line, also between single quotes: it may hold a blank. */
std::string shellWord(const std::string& path);

/** Runs a shell command line with `input` on stdin, as a user would. */
Outcome runProgram(const std::string& command_line, const std::string& input);

}  // namespace poinsot
