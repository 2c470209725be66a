#include "poinsot/audit/report.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <iterator>
#include <limits>
#include <ostream>
#include <utility>

namespace poinsot::audit {

std::string text(const char* format, ...) {
  char buffer[1024];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer, sizeof buffer, format, arguments);
  va_end(arguments);
  return buffer;
}

Judge::Judge(std::string name, std::string body, std::string unit)
    : check_{std::move(name), std::move(body), false, 0, 0, std::move(unit), 0, 0, ""} {}

void Judge::compare(double figure, double bound, double stamp, const Explanation& explain) {
  ++check_.count;
  const bool exceeds = !(figure <= bound);
  const double ratio = exceeds && !(bound > 0 && std::isfinite(figure)) ? std::numeric_limits<double>::infinity()
                       : bound > 0                                      ? figure / bound
                                                                        : 0;
  failures_ += exceeds;
  if (ratio <= worst_ratio_) return;
  worst_ratio_ = ratio;
  check_.worst = figure;
  check_.bound = bound;
  check_.worst_stamp = stamp;
  if (exceeds) explanation_ = explain ? explain() : "";
}

void Judge::fail(double stamp, const std::string& detail) {
  if (first_failure_.empty()) {
    first_failure_ = detail;
    if (worst_ratio_ <= 1) check_.worst_stamp = stamp;
  }
  ++failures_;
}

void Judge::note(const std::string& text) {
  note_ += (note_.empty() ? "" : "; ") + text;
}

Check Judge::verdict() const {
  Check check = check_;
  check.passed = failures_ == 0 && check.count > 0;
  const auto say = [&check](const std::string& what) {
    if (!what.empty()) check.detail += (check.detail.empty() ? "" : "; ") + what;
  };
  say(first_failure_);
  say(explanation_);
  if (failures_ > 0) {
    say(text("%lld of %lld wrong, the worst at stamp %.9f", static_cast<long long>(failures_),
             static_cast<long long>(std::max(check.count, failures_)), check.worst_stamp));
  } else if (check.count == 0) {
    say(if_nothing_);
  }
  say(note_);
  return check;
}

bool Report::passed() const {
  return !checks.empty() && std::all_of(checks.begin(), checks.end(), [](const Check& c) { return c.passed; });
}

std::vector<Check> Report::failures() const {
  std::vector<Check> out;
  std::copy_if(checks.begin(), checks.end(), std::back_inserter(out), [](const Check& c) { return !c.passed; });
  return out;
}

const Check* Report::find(const std::string& name, const std::string& body) const {
  for (const Check& check : checks) {
    if (check.name == name && (body.empty() || check.body == body)) return &check;
  }
  return nullptr;
}

std::ostream& operator<<(std::ostream& out, const Report& report) {
  std::size_t name = 5, body = 4;
  for (const Check& check : report.checks) {
    name = std::max(name, check.name.size());
    body = std::max(body, check.body.size());
  }
  const int name_width = static_cast<int>(name), body_width = static_cast<int>(body);
  out << text("      %-*s  %-*s  %11s  %11s  %-7s  %11s\n", body_width, "body", name_width, "check", "worst", "bound",
              "unit", "comparisons");
  for (const Check& check : report.checks) {
    out << text("%s  %-*s  %-*s  ", check.passed ? "PASS" : "FAIL", body_width, check.body.c_str(), name_width,
                check.name.c_str());
    if (check.count > 0) {
      out << text("%11.3g  %11.3g  %-7s  %11lld\n", check.worst, check.bound, check.unit.c_str(),
                  static_cast<long long>(check.count));
    } else {
      out << text("%11s  %11s  %-7s  %11d\n", "-", "-", check.unit.c_str(), 0);
    }
    if (!check.detail.empty()) out << "      " << check.detail << "\n";
  }
  const std::size_t failed = report.failures().size();
  if (report.checks.empty()) return out << "FAIL: there was nothing to check\n";
  if (failed == 0) return out << text("PASS: all %zu checks\n", report.checks.size());
  return out << text("FAIL: %zu of %zu checks\n", failed, report.checks.size());
}

}  // namespace poinsot::audit
