#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace poinsot::audit {

/** The outcome of one check of a stream. */
struct Check {
  std::string name;
  std::string body;  ///< topic namespace of the body, e.g. "/a/wingnut"
  bool passed = false;
  double worst = 0;        ///< the figure that comes closest to its bound, or exceeds it most
  double bound = 0;        ///< the largest that figure may be
  std::string unit;        ///< of both; empty for ratios
  std::int64_t count = 0;  ///< how many comparisons were made
  double worst_stamp = 0;  ///< stamp at which the worst figure was found [s]
  std::string detail;      ///< what is wrong, or what was left out and why
};

struct Report {
  std::vector<Check> checks;

  /** Returns whether all checks passed; false for a report without any. */
  bool passed() const;
  std::vector<Check> failures() const;
  /** Returns the first check of that name (and of that body, where one is given), or nullptr. */
  const Check* find(const std::string& name, const std::string& body = "") const;
};

/** Prints a line for each check, with its explanation on an indented line below, and a summary at the end. */
std::ostream& operator<<(std::ostream& out, const Report& report);

/** Gathers the comparisons of one check. A check that compared nothing fails, saying so. */
class Judge {
 public:
  using Explanation = std::function<std::string()>;

  Judge(std::string name, std::string body, std::string unit = "");

  /**
   * A figure that should not exceed its bound; NaN counts as exceeding it.
   * @param explain says what is wrong; called only when this is the worst excess so far.
   */
  void compare(double figure, double bound, double stamp, const Explanation& explain = nullptr);

  /** Notes a fault without a figure, as when something is missing. */
  void fail(double stamp, const std::string& detail);

  /** Adds to the detail, whether the check passes or not. */
  void note(const std::string& text);

  /** Sets the detail for the case that nothing could be compared. */
  void ifNothing(const std::string& text) { if_nothing_ = text; }

  std::int64_t count() const { return check_.count; }
  Check verdict() const;

 private:
  Check check_;
  double worst_ratio_ = -1;
  std::int64_t failures_ = 0;
  std::string explanation_, first_failure_, note_;
  std::string if_nothing_ = "there was nothing to compare";
};

/** Returns the text that printf would print. */
std::string text(const char* format, ...) __attribute__((format(printf, 1, 2)));

}  // namespace poinsot::audit
