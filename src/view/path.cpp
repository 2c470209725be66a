#include "poinsot/view/path.h"

#include <algorithm>

namespace poinsot::view {

Path::Path(std::size_t most_pieces, std::size_t points_per_piece, double tolerance, double longest)
    : most_pieces_(std::max<std::size_t>(most_pieces, 1)),
      points_per_piece_(std::max<std::size_t>(points_per_piece, 2)),
      tolerance_(tolerance),
      longest_(longest) {}

void Path::add(const Eigen::Vector3d& point) {
  if (!point.allFinite()) return;
  if (pieces_.empty()) {
    pieces_.emplace_back(1, point);
    return;
  }
  if (pending_) {
    const Eigen::Vector3d way = point - pieces_.back().back();
    const bool bends = (way - way.dot(heading_) * heading_).norm() > tolerance_ || way.dot(heading_) < 0;
    if (bends || way.norm() > longest_) {
      keep(newest_);
      pending_ = false;
    }
  }
  const Eigen::Vector3d way = point - pieces_.back().back();
  if (!pending_ && way.norm() > tolerance_) {  // nearer, its direction is not known yet
    heading_ = way.normalized();
    pending_ = true;
  }
  newest_ = point;
}

void Path::keep(const Eigen::Vector3d& point) {
  if (pieces_.back().size() == points_per_piece_) {
    const Eigen::Vector3d joint = pieces_.back().back();
    pieces_.emplace_back(1, joint);
    if (pieces_.size() > most_pieces_) {
      pieces_.pop_front();
      ++first_;
    }
  }
  pieces_.back().push_back(point);
}

void Path::clear() {
  pieces_.clear();
  first_ = 0;
  pending_ = false;
}

}  // namespace poinsot::view
