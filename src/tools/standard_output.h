#pragma once

#include <iostream>
#include <stdexcept>

namespace poinsot::tools {

/** Flushes standard output. Throws std::runtime_error where that fails. */
inline void flushStandardOutput() {
  std::cout << std::flush;
  if (!std::cout) {
    throw std::runtime_error("cannot write standard output: the disk is full, or nobody reads it");
  }
}

}  // namespace poinsot::tools
