#pragma once

#include <stdexcept>
#include <string>

namespace poinsot {

[[noreturn]] inline void refuse(const std::string& what) {
  throw std::invalid_argument(what);
}

}  // namespace poinsot
