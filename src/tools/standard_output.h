#pragma once

#include <iostream>
#include <stdexcept>

namespace poinsot::tools {

/** Brings what was printed to its reader. Throws std::runtime_error where it does not arrive. */
inline void flushStandardOutput() {
  std::cout << std::flush;
  if (!std::cout) {
    throw std::runtime_error("cannot write standard output: the disk is full, or nobody reads it");
  }
}

}  // namespace poinsot::tools
