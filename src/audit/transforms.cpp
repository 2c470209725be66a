#include <algorithm>

#include "poinsot/audit/recording.h"

namespace poinsot::audit {

void Transforms::add(const std::string& child, Stamp stamp, const Transform& transform, bool is_static) {
  if (is_static) {
    fixed_[child] = transform;
  } else {
    moving_[child].add(stamp, transform);
  }
}

const Track<Transform>* Transforms::moving(const std::string& child) const {
  const auto found = moving_.find(child);
  return found == moving_.end() ? nullptr : &found->second;
}

const Transform* Transforms::fixed(const std::string& child) const {
  const auto found = fixed_.find(child);
  return found == fixed_.end() ? nullptr : &found->second;
}

std::vector<std::pair<std::string, Eigen::Isometry3d>> Transforms::chainToRoot(const std::string& frame, Stamp stamp,
                                                                               const Eigen::Quaterniond& near) const {
  std::vector<std::pair<std::string, Eigen::Isometry3d>> chain{{frame, Eigen::Isometry3d::Identity()}};
  // Frames that form a loop are no tree: 64 is deeper than any of ours.
  while (chain.size() < 64) {
    const Transform* step = fixed(chain.back().first);
    if (!step) {
      const Track<Transform>* moving = this->moving(chain.back().first);
      step = moving ? moving->at(stamp, near) : nullptr;
      if (!step) break;
    }
    if (!step->flaw.empty()) break;
    const Eigen::Isometry3d up = Eigen::Translation3d(step->position) * step->attitude * chain.back().second;
    chain.emplace_back(step->frame_id, up);
  }
  return chain;
}

std::optional<Eigen::Isometry3d> Transforms::between(const std::string& from, const std::string& to, Stamp stamp,
                                                     const Eigen::Quaterniond& near) const {
  if (from == to) return Eigen::Isometry3d::Identity();
  // Up from both sides to the first frame in common, so that nothing above it costs digits.
  const auto up = chainToRoot(from, stamp, near), down = chainToRoot(to, stamp, near);
  for (const auto& a : up) {
    for (const auto& b : down) {
      if (a.first == b.first) return b.second.inverse(Eigen::Isometry) * a.second;
    }
  }
  return std::nullopt;
}

}  // namespace poinsot::audit
