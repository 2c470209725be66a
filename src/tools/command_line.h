#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include "bad_use.h"

namespace poinsot::tools {

constexpr int kBadUse = 2;  // exit code

/**
 * Adds an option that takes a positive finite number.
 * @param value gets the number; what it holds before is shown as the default.
 * @param unit as messages show it, such as "s"; empty for a pure number.
 */
CLI::Option* addPositive(CLI::App& app, const std::string& name, std::optional<double>& value, const std::string& unit,
                         const std::string& description);

/** Returns the check of an option that takes any text but an empty one. */
CLI::Validator notEmpty();

/** Returns the check of an option that takes one of a few words. */
CLI::Validator oneOf(const std::vector<std::string>& words);

/** Refuses an output file that is another file of the program; `other_name` is how a message calls that. */
void refuseSameFile(const std::string& option, const std::string& path, const std::string& other_name,
                    const std::string& other);

/** Parses the command line; returns the code to exit with at once, after --help or bad use. */
std::optional<int> parse(CLI::App& app, int argc, char** argv);

/**
 * Does the work of a program and returns its exit code: 0, or after an exception, which is printed on stderr, `code`
 * for the types Special and `other_code` for all others.
 */
template <class... Special>
int exitCodeOf(const char* program, int code, int other_code, const std::function<void()>& work) {
  try {
    work();
    return 0;
  } catch (const std::exception& error) {
    std::cerr << program << ": " << error.what() << "\n";
    return (... || dynamic_cast<const Special*>(&error)) ? code : other_code;
  }
}

}  // namespace poinsot::tools
