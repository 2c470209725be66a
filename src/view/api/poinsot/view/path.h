#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>
#include <vector>

namespace poinsot::view {

/**
 * A path with its points thinned, for drawing. It consists of pieces, of which only the last changes, so that the
 * others need not be drawn anew. Each piece begins where the one before ends; where there are too many, the oldest is
 * dropped.
 *
 * The caller clears it when the motion jumps.
 */
class Path {
 public:
  /**
   * @param most_pieces kept, at least 1.
   * @param points_per_piece at least 2.
   * @param tolerance how far points that are left out may lie off the line [the points' unit].
   * @param longest distance at which a point is kept in any case [the points' unit].
   */
  Path(std::size_t most_pieces, std::size_t points_per_piece, double tolerance, double longest);

  /** Adds a point. Ignored unless finite. */
  void add(const Eigen::Vector3d& point);

  void clear();

  /** Pieces are numbered from the first since clear(); those with firstPiece() ≤ k < endPiece() are kept. */
  std::size_t firstPiece() const { return first_; }
  std::size_t endPiece() const { return first_ + pieces_.size(); }

  /** Returns the points of piece k, the oldest first; of the last piece up to the newest point that was kept. */
  const std::vector<Eigen::Vector3d>& piece(std::size_t k) const { return pieces_[k - first_]; }

 private:
  void keep(const Eigen::Vector3d& point);

  std::size_t most_pieces_, points_per_piece_;
  double tolerance_, longest_;
  std::deque<std::vector<Eigen::Vector3d>> pieces_;
  std::size_t first_ = 0;
  bool pending_ = false;     ///< newest_ is not kept yet
  Eigen::Vector3d newest_;   ///< the last point added
  Eigen::Vector3d heading_;  ///< of the path from the last point that was kept, a unit vector
};

}  // namespace poinsot::view
