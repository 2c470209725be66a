#pragma once

#include <stdexcept>
#include <string>

namespace poinsot {

/** The implicit equation of a step has not been solved: the step is too long for the method and this body. */
class NoConvergence : public std::runtime_error {
 public:
  /** @param method its name, for the message. */
  explicit NoConvergence(const std::string& method)
      : std::runtime_error(method + " finds no solution of its implicit equation: the step is too long for this body") {
  }
};

}  // namespace poinsot
