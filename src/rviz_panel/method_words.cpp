#include "method_words.h"

namespace poinsot::rviz_panel {
namespace {

const char* const kTaylor = "Taylor series";
const char* const kBuss = "more terms of Taylor's series in one turn";
const char* const kSplitting = "turns about axes, reversible";
const char* const kMoserVeselov = "discrete Moser–Veselov, reversible";

const char* kept(const MethodWords& method) {
  if (!method.moves_free) return "under torques";
  if (method.keeps_momentum) return method.keeps_energy ? "keeps L and E" : "keeps L, not E";
  return method.keeps_energy ? "keeps E, not L" : "keeps neither L nor E";
}

}  // namespace

const std::vector<MethodWords>& methodWords() {
  static const std::vector<MethodWords> table = {
      // name, what it is, order, moves free bodies, keeps L, keeps E
      {"closed_form", "exact, any t at once", 0, true, true, true},
      {"lie_euler", "course notes' Algorithm 1", 1, true, true, false},
      {"buss2", "course notes' Algorithm 2", 2, true, true, false},
      {"buss3", kBuss, 3, true, true, false},
      {"buss4", kBuss, 4, true, true, false},
      {"rk4", "classical Runge–Kutta", 4, true, false, false},
      {"rkmk4", "Runge–Kutta on the group (Munthe-Kaas)", 4, true, true, false},
      {"cf4", "commutator-free, two turns a step", 4, true, true, false},
      {"midpoint", "implicit midpoint, reversible", 2, true, true, false},
      {"splitting2", kSplitting, 2, true, true, false},
      {"splitting4", kSplitting, 4, true, true, false},
      {"splitting6", kSplitting, 6, true, true, false},
      {"dmv2", kMoserVeselov, 2, true, true, true},
      {"dmv4", kMoserVeselov, 4, true, true, true},
      {"dmv6", kMoserVeselov, 6, true, true, true},
      {"dmv8", kMoserVeselov, 8, true, true, true},
      {"dmv10", kMoserVeselov, 10, true, true, true},
      {"taylor8", kTaylor, 8, false, false, false},
      {"taylor12", kTaylor, 12, false, false, false},
      {"taylor16", kTaylor, 16, false, false, false},
      {"taylor20", kTaylor, 20, false, false, false},
      {"taylor24", kTaylor, 24, false, false, false},
      {"aba84", "free motion and kicks in turn", 4, false, false, false},
  };
  return table;
}

QString wordsOfMethod(const QString& name) {
  for (const MethodWords& method : methodWords()) {
    if (name != method.name) continue;
    if (method.order == 0) return QString("%1, %2").arg(method.what, kept(method));
    return QString("%1, order %2, %3").arg(method.what).arg(method.order).arg(kept(method));
  }
  return {};
}

}  // namespace poinsot::rviz_panel
