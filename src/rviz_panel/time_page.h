#pragma once

namespace poinsot::rviz_panel {

/** The stretch of simulation time that a slider of finite length shows: like a page of a book, it turns to where t is.
 */
class TimePage {
 public:
  /** Pages of `span` seconds that begin at 0, or, with `both_sides`, of twice that, the middle of one at 0. */
  explicit TimePage(double span = 60, bool both_sides = false);

  double from() const { return from_; }
  double to() const { return from_ + width_; }

  /** Turns to the page with t on it; stays where t is on this one, its edges included. Not finite: stays. */
  void turnTo(double t);

  /** Where t is on the page, from 0 to 1; what is not on it counts as its nearer edge. */
  double shareAt(double t) const;
  double timeAt(double share) const { return from_ + share * width_; }

 private:
  double width_;
  double origin_;
  double from_;
};

}  // namespace poinsot::rviz_panel
