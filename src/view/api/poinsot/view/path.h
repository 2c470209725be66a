#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <deque>
#include <vector>

namespace poinsot::view {

/**
 * All of a path that was travelled, thinned, for drawing: in pieces, of which all but the last never change again, so
 * that they need not be drawn anew. Each piece begins where the one before ends. The oldest pieces go when there are
 * too many.
 *
 * The caller clears it at a jump.
 */
class Path {
 public:
  /**
   * @param most_pieces kept, at least 1.
   * @param points_per_piece at least 2.
   * @param tolerance how far points that are left out may lie off the line that is kept [the points' unit].
   * @param longest distance between points that are kept [the points' unit]; samples further apart are all kept.
   */
  Path(std::size_t most_pieces, std::size_t points_per_piece, double tolerance, double longest);

  /** Adds a point. Ignored unless finite. */
  void add(const Eigen::Vector3d& point);

  void clear();

  /** Pieces are numbered from the first that there ever was since clear(); kept are firstPiece() ≤ k < endPiece(). */
  std::size_t firstPiece() const { return first_; }
  std::size_t endPiece() const { return first_ + pieces_.size(); }

  /** The points of piece k, the oldest first; of the last piece up to the newest point that was kept. */
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
