#include <algorithm>

#include "poinsot/audit/recording.h"

namespace poinsot::audit {

void Transforms::add(const std::string& child, Stamp stamp, const Transform& transform, bool is_static) {
  if (is_static) {
    fixed_[child] = transform;
    return;
  }
  Moving& moving = moving_[child];
  if (!moving.by_stamp.empty() && stamp < moving.last) ++moving.backwards;
  moving.last = stamp;
  moving.by_stamp.emplace(stamp, transform);
}

const std::multimap<Stamp, Transform>* Transforms::moving(const std::string& child) const {
  const auto found = moving_.find(child);
  return found == moving_.end() ? nullptr : &found->second.by_stamp;
}

std::int64_t Transforms::backwards(const std::string& child) const {
  const auto found = moving_.find(child);
  return found == moving_.end() ? 0 : found->second.backwards;
}

std::vector<std::string> Transforms::movingFrames() const {
  std::vector<std::string> names;
  for (const auto& entry : moving_) names.push_back(entry.first);
  return names;
}

const Transform* Transforms::fixed(const std::string& child) const {
  const auto found = fixed_.find(child);
  return found == fixed_.end() ? nullptr : &found->second;
}

std::vector<std::pair<std::string, Eigen::Isometry3d>> Transforms::chainToRoot(const std::string& frame,
                                                                               Stamp stamp) const {
  std::vector<std::pair<std::string, Eigen::Isometry3d>> chain{{frame, Eigen::Isometry3d::Identity()}};
  // Frames that form a loop are no tree: 64 is deeper than any of ours.
  while (chain.size() < 64) {
    const Transform* step = fixed(chain.back().first);
    if (!step) {
      const auto* moving = this->moving(chain.back().first);
      const auto found = moving ? moving->find(stamp) : std::multimap<Stamp, Transform>::const_iterator();
      if (!moving || found == moving->end()) break;
      step = &found->second;
    }
    if (!step->flaw.empty()) break;
    const Eigen::Isometry3d up = Eigen::Translation3d(step->translation) * step->rotation * chain.back().second;
    chain.emplace_back(step->parent, up);
  }
  return chain;
}

std::optional<Eigen::Isometry3d> Transforms::between(const std::string& from, const std::string& to,
                                                     Stamp stamp) const {
  if (from == to) return Eigen::Isometry3d::Identity();
  // Up from both sides to the first frame in common, so that nothing above it costs digits.
  const auto up = chainToRoot(from, stamp), down = chainToRoot(to, stamp);
  for (const auto& a : up) {
    for (const auto& b : down) {
      if (a.first == b.first) return b.second.inverse(Eigen::Isometry) * a.second;
    }
  }
  return std::nullopt;
}

}  // namespace poinsot::audit
