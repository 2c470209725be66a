#pragma once

#include <stdexcept>
#include <string>

namespace poinsot {

/** Thrown where the implicit equation of a step is not solved, because the step is too long for the method and body. */
class NoConvergence : public std::runtime_error {
 public:
  /** @param method its name. */
  explicit NoConvergence(const std::string& method)
      : std::runtime_error(method + " finds no solution of its implicit equation: the step is too long for this body") {
  }
};

}  // namespace poinsot
