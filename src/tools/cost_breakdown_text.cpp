#include "cost_breakdown_text.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace poinsot::tools {
namespace {

constexpr double kNano = 1e9;
const char* const kTotal = "total";

[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...) {
  char text[512];
  std::va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

/** Returns a measured time in nanoseconds, or a plain 0 for a part that is not there. */
std::string measured(double seconds, bool there) {
  return there ? formatted("%.2f", kNano * seconds + 0.0) : "0";
}

std::string row(const std::string& name, const cost::CostBreakdown& breakdown, const cost::CostBreakdown::Part& part) {
  const bool stepped = part.in_force && breakdown.steps > 0;
  const double share = breakdown.perSecond(part) / breakdown.perSecond();
  return formatted("  %-22s %12s %13s %20s %9s\n", name.c_str(), measured(part.per_step, stepped).c_str(),
                   measured(part.per_state, part.in_force).c_str(),
                   measured(breakdown.perSecond(part), part.in_force).c_str(),
                   part.in_force ? formatted("%.1f %%", 100 * share).c_str() : "0");
}

cost::CostBreakdown::Part total(const cost::CostBreakdown& breakdown) {
  return {kTotal, true, breakdown.perStep(), breakdown.perState()};
}

std::string csvRow(const scene::Body& body, const cost::CostBreakdown& breakdown,
                   const cost::CostBreakdown::Part& part) {
  const bool is_total = part.name == kTotal;
  return body.name + "," + body.method + "," + (body.step ? formatted("%.9g", *body.step) : "") + "," + part.name +
         "," + (part.in_force ? "1" : "0") +
         formatted(",%.9g,%.9g,%.9g,%.9g,", kNano * part.per_step, kNano * part.per_state,
                   kNano * breakdown.perSecond(part), breakdown.perSecond(part) / breakdown.perSecond()) +
         (is_total ? formatted("%.9g,%.9g", breakdown.torque_evaluations, kNano * breakdown.run) : ",") + "\n";
}

}  // namespace

std::string costBreakdownText(const scene::Body& body, const std::string& why, const cost::CostBreakdown& breakdown) {
  std::string effects;
  if (body.translation)
    effects += std::string("  in force  ") + Translation::kName + ": " + body.translation->text() + "\n";
  for (const Effect& effect : body.effects) effects += "  in force  " + textOf(effect) + "\n";
  if (effects.empty()) effects = "  in force  no effect\n";

  std::string out = body.name + "\n" + effects + "  method    " + body.method;
  if (body.step) out += formatted(", step %.9g s", *body.step);
  out += "\n  why       " + why + "\n";
  out += formatted("  %-22s %12s %13s %20s %9s\n", "", "ns per step", "ns per state", "ns per simulated s", "share");
  for (const cost::CostBreakdown::Part& part : breakdown.parts) out += row(part.name, breakdown, part);
  out += row(kTotal, breakdown, total(breakdown));
  out += formatted("  in a simulated second: %.6g steps, %.6g states, %.6g torque evaluations\n", breakdown.steps,
                   breakdown.states, breakdown.torque_evaluations);
  out += formatted("  run through once: %.0f ns per simulated s; the total above is %.3f of it\n",
                   kNano * breakdown.run, breakdown.perSecond() / breakdown.run);
  return out;
}

std::string costBreakdownHeader() {
  return "body,method,step,part,in_force,ns_per_step,ns_per_state,ns_per_simulated_s,share,torque_evaluations_per_s,"
         "ns_of_a_run_per_simulated_s\n";
}

std::string costBreakdownRows(const scene::Body& body, const cost::CostBreakdown& breakdown) {
  std::string out;
  for (const cost::CostBreakdown::Part& part : breakdown.parts) out += csvRow(body, breakdown, part);
  return out + csvRow(body, breakdown, total(breakdown));
}

}  // namespace poinsot::tools
