#include <algorithm>
#include <string>
#include <vector>

#include "markers/layout.h"
#include "markers/parts.h"
#include "poinsot/ros/conversions.h"
#include "poinsot/ros/markers/palette.h"
#include "poinsot/view/path.h"
#include "poinsot/view/picture_scale.h"
#include "poinsot/view/trail.h"

namespace poinsot::node::parts {
namespace {

constexpr double kTrailShare = 0.6;          // of the polhode: a trail that met itself would flicker
constexpr double kStrayTrailShare = 1.5;     // where Ω may leave the polhode, to be seen doing so
constexpr double kTorquedTrailLength = 1.5;  // m
constexpr double kTrailSpacing = 0.03;       // m

constexpr std::size_t kPathPieces = kTrailIds - 1;
constexpr std::size_t kPiecePoints = 256;  // 16384 together: RViz shows no more of a line
constexpr std::size_t kPiecesAtOnce = 16;
constexpr double kPathTolerance = 0.002;  // m
constexpr double kPathSpacing = 0.2;      // m, at most
constexpr session::Nanoseconds kPathPause = session::kSecond / 4;

/** Returns the length of the polhode that Ω runs through [rad/s]. */
double lengthOf(const view::Polhode& polhode) {
  double length = 0;
  if (polhode.branches.empty()) return length;
  const std::vector<Eigen::Vector3d>& points = polhode.branches.front().points;
  for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
  return length;
}

/** The newest stretch of the path of Ω; it fades towards its end. */
class Trail : public Part {
 public:
  explicit Trail(double length)  // [m]
      : trail_(2 + static_cast<std::size_t>(length / kTrailSpacing), length, kTrailSpacing) {}

  void appendMoving(const Subject& subject, const Now& now, Canvas& canvas) override {
    append(layout::kTrailLift * subject.radii() * now.state.omega_body, subject, canvas);
  }

  void clearTrail() override { trail_.clear(); }

 protected:
  void append(const Eigen::Vector3d& place, const Subject& subject, Canvas& canvas) {
    trail_.add(place);
    Marker line = subject.factory.marker(
        subject.factory.ns(names::kTrail), 0, Marker::LINE_STRIP, subject.factory.frames().model,
        {layout::kTrailWidth, 0, 0},
        palette::translucent(palette::kOmega, 0.99f));  // opaque, RViz would not blend the points' colours
    for (std::size_t i = 0; i < trail_.size(); ++i) {
      line.points.push_back(toPoint(trail_[i]));
      const float youth = static_cast<float>(i + 1) / static_cast<float>(trail_.size());
      line.colors.push_back(palette::translucent(palette::kOmega, youth));
    }
    canvas.show(trail_.size() > 1, line);  // after a jump the old one would stay where it was
  }

 private:
  view::Trail trail_;
};

class Path : public Trail {
 public:
  explicit Path(bool rides) : Trail(kTorquedTrailLength), rides_(rides) {}

  void appendMoving(const Subject& subject, const Now& now, Canvas& canvas) override {
    const Eigen::Vector3d omega = subject.radii() * now.state.omega_body;
    // Where an ellipsoid is long and thin, a larger Ω would be no higher above its flanks: lifted along the normal
    // instead, of which each ellipsoid has its own.
    const Eigen::Vector3d& moments = subject.inertia.moments();
    const Eigen::Quaterniond& axes = subject.inertia.axes();
    const Eigen::Vector3d energy_normal = moments.cwiseProduct(axes.conjugate() * omega);
    const Eigen::Vector3d momentum_normal = moments.cwiseProduct(energy_normal);
    const Eigen::Vector3d normal =
        axes * (energy_normal.stableNormalized() + momentum_normal.stableNormalized()).stableNormalized();
    append(omega + layout::kTorquedTrailHeight * normal, subject, canvas);

    const std::size_t before = path_.endPiece();
    // While a slug takes momentum up or gives it back, |MΩ| changes: the spiral is kept on an ellipsoid of 1 m and
    // drawn on the present one, which would hide it or leave it in the air else.
    const double semi_axis = energy_normal.norm() / moments.minCoeff();
    size_ = rides_ && semi_axis > 0 ? semi_axis / view::kPictureRadius : 1;
    path_.add(omega / size_ + layout::kPathHeight * normal);
    if (jumped_) canvas.remove(subject.factory.ns(names::kTrail), 1);
    if (path_.endPiece() > before && before > 0 && !jumped_)
      appendPiece(before - 1, subject, canvas);  // now that it is whole
    jumped_ = false;
    if (!cadence_.due(now.tick.stamp)) return;
    appendPiece(path_.endPiece() - 1, subject, canvas);
    appendOlder(subject, canvas);
  }

  void clearTrail() override {
    Trail::clearTrail();
    path_.clear();
    jumped_ = true;
    cadence_.reset();
  }

  void sendAllNext() override { cadence_.reset(); }

 private:
  /** Appends pieces before the last: the newest where the size has changed; else one in turn, for later viewers. */
  void appendOlder(const Subject& subject, Canvas& canvas) {
    const std::size_t last = path_.endPiece() - 1;
    if (last == path_.firstPiece()) return;
    if (differs(size_, drawn_size_)) {
      drawn_size_ = size_;
      const std::size_t first = std::max(path_.firstPiece(), last - std::min(last, kPiecesAtOnce));
      for (std::size_t k = first; k < last; ++k) appendPiece(k, subject, canvas);
      if (first == path_.firstPiece()) return;
    }
    turn_ = turn_ + 1 < last && turn_ + 1 >= path_.firstPiece() ? turn_ + 1 : path_.firstPiece();
    appendPiece(turn_, subject, canvas);
  }

  void appendPiece(std::size_t k, const Subject& subject, Canvas& canvas) const {
    const std::vector<Eigen::Vector3d>& points = path_.piece(k);
    if (points.size() < 2) return;
    // A new piece takes the place of the one that has gone.
    const int id = 1 + static_cast<int>(k % kPathPieces);
    canvas.put(subject.factory.curve(subject.factory.ns(names::kTrail), id, subject.factory.frames().model,
                                     {points, false}, size_, layout::kPathWidth, 0, palette::kPath));
  }

  view::Path path_{kPathPieces, kPiecePoints, kPathTolerance, kPathSpacing};
  bool rides_;
  double size_ = 1;        ///< of the ellipsoid that it rides on now; 1 where it does not
  double drawn_size_ = 1;  ///< at which all of it was last drawn
  bool jumped_ = false;    ///< what was shown of it is no more
  Cadence cadence_{kPathPause};
  std::size_t turn_ = 0;  ///< the piece that was sent once more
};

}  // namespace

std::unique_ptr<Part> makeTrail(const Subject& subject, const Motion& motion) {
  const double share = motion.inClosedForm() ? kTrailShare : kStrayTrailShare;
  return std::make_unique<Trail>(lengthOf(subject.polhode) * (share * subject.radii()));
}

std::unique_ptr<Part> makePath(bool rides) {
  return std::make_unique<Path>(rides);
}

}  // namespace poinsot::node::parts
