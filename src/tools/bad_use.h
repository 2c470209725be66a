#pragma once

#include <stdexcept>
#include <string>

namespace poinsot::tools {

/** An option that is wrong, or that does not go with others or with the scene; what() is "OPTION: expected X, got Y".
 */
struct BadUse : std::runtime_error {
  BadUse(const std::string& option, const std::string& expected, const std::string& got)
      : std::runtime_error(option + ": expected " + expected + ", got " + got) {}
};

}  // namespace poinsot::tools
