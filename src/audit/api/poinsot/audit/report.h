#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace poinsot::audit {

/** One question asked of a stream, and its answer. */
struct Check {
  std::string name;
  std::string body;  ///< topic namespace of the body, e.g. "/a/wingnut"
  bool passed = false;
  double worst = 0;        ///< the figure that comes closest to its bound, or exceeds it most
  double bound = 0;        ///< what that figure may be
  std::string unit;        ///< of both; empty for ratios
  std::int64_t count = 0;  ///< how many comparisons were made
  double worst_stamp = 0;  ///< stamp at which the worst figure was found [s]
  std::string detail;      ///< in plain words: what is wrong, or what was not looked at and why
};

struct Report {
  std::vector<Check> checks;

  /** False also for a report without any check: nothing was shown to be right. */
  bool passed() const;
  std::vector<Check> failures() const;
  /** The first check of that name (of that body, where one is given), or nullptr. */
  const Check* find(const std::string& name, const std::string& body = "") const;
};

/** A line per check, an indented line of explanation below where there is one, and a summary at the end. */
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

  /** Something is wrong that no figure measures (something is missing, say). */
  void fail(double stamp, const std::string& detail);

  /** Said in the report whether the check passes or not. */
  void note(const std::string& text);

  /** What to say where nothing could be compared. */
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

/** printf into a string. */
std::string text(const char* format, ...) __attribute__((format(printf, 1, 2)));

}  // namespace poinsot::audit
