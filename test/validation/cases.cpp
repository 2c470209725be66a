#include "cases.h"

#include <ostream>

namespace poinsot::validation {

std::ostream& operator<<(std::ostream& out, const Case& one) {
  return out << one.name;
}

std::vector<Case> allCases() {
  std::vector<Case> all = freeCases();
  all.insert(all.end(), torqueCases().begin(), torqueCases().end());
  return all;
}

testing::AssertionResult agrees(const Case& one, const std::vector<double>& figures) {
  testing::AssertionResult all = testing::AssertionSuccess();
  for (const Claim& claim : one.claims) {
    const testing::AssertionResult here = agrees(claim, figures.at(claim.of));
    if (here) continue;
    if (all) all = testing::AssertionFailure();
    all << here.message() << '\n';
  }
  return all;
}

std::vector<std::string> rows(const Case& one, const std::vector<double>& figures) {
  std::vector<std::string> lines;
  for (auto claim = one.claims.begin(); claim != one.claims.end();) {
    std::string published, computed;
    const auto first = claim;
    for (; claim != one.claims.end() && claim->figure == first->figure && claim->source == first->source; ++claim) {
      const char* const comma = claim == first ? "" : ", ";
      published += comma + claim->published;
      computed += comma + shown(*claim, figures.at(claim->of));
    }
    lines.push_back("| " + (lines.empty() ? "`" + one.name + "` | " + one.inputs : " |") + " | " + first->figure +
                    " | " + first->source + " | " + published + first->allowed + " | " + computed + " |");
  }
  return lines;
}

MotionSetup swapped(const MotionSetup& setup, const std::array<int, 2>& pair) {
  MotionSetup wrong = setup;
  Eigen::Vector3d moments = setup.inertia.moments();
  std::swap(moments[pair[0]], moments[pair[1]]);
  wrong.inertia = PrincipalInertia::fromMoments(moments);
  return wrong;
}

}  // namespace poinsot::validation
