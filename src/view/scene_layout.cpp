#include "poinsot/view/scene_layout.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace poinsot::view {
namespace {

// All lengths in radii of a picture, as a viewer at +x sees them.
constexpr double kGap = 0.2;
constexpr double kRound = 1.25;        // what a picture reaches on all sides, with the name of Ω or ω
constexpr double kAboveBead = 1.45;    // upwards, that in body axes, where the name of Ω may stand
constexpr double kArrowReach = 1.85;   // of L's arrow with its name, where L points that way
constexpr double kMovingReach = 1.6;   // of L's arrow where it moves
constexpr double kBelowBody = 0.38;    // the title's middle, below the body
constexpr double kBelowSymbol = 0.3;   // more of that, where the body is small beside the names of its arrows:
constexpr double kSmallBody = 0.5;     // its radius
constexpr double kTitleHeight = 0.21;  // with kLineHeight: see ros/markers/layout.h
constexpr double kLineHeight = 0.235;
constexpr int kPictureLines = 2;           // below the title of a picture
constexpr double kHalfWords = 1.15;        // the width of the words of a body that steps, or of a picture's
constexpr double kHalfLetter = 0.055;      // of a title: half the width of a letter, in the mean
constexpr int kLettersOfPicture = 15;      // of the title of a picture, besides the name of its body
constexpr double kHalfFigures = 1.1;       // of a body's figures
constexpr int kFigures = 3;                // lines: from so many on they are figures
constexpr double kSmallestLetters = 0.17;  // the height of the smallest letters
constexpr double kApart = 4;               // where pictures stand apart, in widths of the overview
constexpr double kApartSpacing = 4;

constexpr double kUsualAspect = 1.7;             // of a full screen, or a little less
constexpr double kReadable = 12.6 / 450;         // of the height of the overview, for the smallest letters
constexpr double kSmallest = 0.3, kLargest = 3;  // letters, relative to those for one body
constexpr double kTogetherIsWorse = 1.15;   // pictures away from their bodies, by how much farther they may be seen
constexpr double kMeetingIsWorse = 1e6;     // taken where there is nothing else
constexpr std::size_t kMostCompared = 300;  // bodies: with more, all pictures stand together
constexpr int kTextRounds = 6;
constexpr double kPitch = 0.3, kFlatPitch = 0.15;  // of one body, of several

/** A rectangle across the line of sight: y to the right, z upwards. */
struct Box {
  double y0 = std::numeric_limits<double>::infinity(), y1 = -y0, z0 = y0, z1 = -y0;

  void add(double y, double z, double half_width, double half_height) {
    y0 = std::min(y0, y - half_width);
    y1 = std::max(y1, y + half_width);
    z0 = std::min(z0, z - half_height);
    z1 = std::max(z1, z + half_height);
  }
  void add(const Box& other) {
    y0 = std::min(y0, other.y0);
    y1 = std::max(y1, other.y1);
    z0 = std::min(z0, other.z0);
    z1 = std::max(z1, other.z1);
  }
  bool meets(const Box& other) const { return y0 < other.y1 && other.y0 < y1 && z0 < other.z1 && other.z0 < z1; }
};

/** How far something reaches from its centre. */
struct Reach {
  double left = kRound, right = kRound, up = kRound, down = kRound;
};

enum class Which { world, body, orbit };

/** `place.*centre(which)` is where that picture stands. */
Eigen::Vector3d BodyPlace::*centre(Which which) {
  return which == Which::world  ? &BodyPlace::space_centre
         : which == Which::body ? &BodyPlace::model_centre
                                : &BodyPlace::orbit_centre;
}

/** A body with the pictures that stand beside it, its lengths in metres. */
class Cell {
 public:
  Cell(const BodyExtent& extent, double unit, double text) : extent_(extent), unit_(unit), text_(text) {
    if (extent.shows_world) shown_.push_back(Which::world);
    if (extent.shows_body) shown_.push_back(Which::body);
    if (extent.shows_orbit) shown_.push_back(Which::orbit);
  }

  const std::vector<Which>& shown() const { return shown_; }
  bool shows(Which which) const { return std::count(shown_.begin(), shown_.end(), which) > 0; }
  const Eigen::Vector3d& start() const { return extent_.body.front().centre; }

  /** The place of the body's title so far below its start, or at least below the body. */
  Eigen::Vector3d titleBelow(double depth = 0) const {
    const double below = kBelowBody + (extent_.radius < kSmallBody * unit_ ? kBelowSymbol : 0);
    return start() - Eigen::Vector3d(0, 0, std::max(depth, extent_.body.front().radius + unit_ * below * text_));
  }
  double pictureTitleDepth() const { return unit_ * extent_.picture_depth; }

  /** The place of the title to the right of the body, with the words below it: both together as high as the middle. */
  Eigen::Vector3d titleBeside() const {
    const Box body = bodyAlone();
    const double height = unit_ * text_ * kLineHeight * extent_.lines;
    return {start().x(), body.y1 + unit_ * (kGap + text_ * halfWords()), 0.5 * (body.z0 + body.z1 + height)};
  }

  /** The body, wherever it is to be in view. */
  Box bodyAlone() const {
    Box out;
    for (const Ball& ball : extent_.body) out.add(ball.centre.y(), ball.centre.z(), ball.radius, ball.radius);
    return out;
  }

  /** The body with its words. */
  Box bodyBox(const BodyPlace& place) const {
    Box out = bodyAlone();
    if (extent_.has_words) out.add(wordsBox(place.title, extent_.lines, halfWords()));
    return out;
  }

  /** The picture with its words, its middle being there. */
  Box pictureBox(Which which, const Eigen::Vector3d& middle, const BodyPlace& place) const {
    const Reach reach = reachOf(which);
    Box out = wordsBox(middle - Eigen::Vector3d(0, 0, place.picture_title_depth), linesOf(which), halfWordsOf(place));
    out.y0 = std::min(out.y0, middle.y() - reach.left);
    out.y1 = std::max(out.y1, middle.y() + reach.right);
    out.z0 = std::min(out.z0, middle.z() - reach.down);
    out.z1 = middle.z() + reach.up;
    return out;
  }

  /** How far the picture reaches, lengths in metres. */
  Reach reachOf(Which which) const {
    Reach out;
    if (which == Which::body) out.up = kAboveBead;
    if (which == Which::orbit) out = {kMovingReach, kMovingReach, kMovingReach, kMovingReach};
    if (which == Which::world) {
      const auto along = [&](double component) {
        return extent_.momentum ? std::max(kRound, kArrowReach * component) : kMovingReach;
      };
      const Eigen::Vector3d l = extent_.momentum.value_or(Eigen::Vector3d::Zero());
      out = {along(-l.y()), along(l.y()), along(l.z()), along(-l.z())};
    }
    for (double* side : {&out.left, &out.right, &out.up, &out.down}) *side *= unit_;
    return out;
  }

  /** The same across, or how far the words below the picture reach, if that is farther. */
  double leftOf(Which which, const BodyPlace& place) const {
    return std::max(reachOf(which).left, unit_ * text_ * halfWordsOf(place));
  }
  double rightOf(Which which, const BodyPlace& place) const {
    return std::max(reachOf(which).right, unit_ * text_ * halfWordsOf(place));
  }

  /** Puts what an overview shows of the body, and of the pictures beside it. */
  void appendBalls(const BodyPlace& place, std::vector<Ball>& out) const {
    out.insert(out.end(), extent_.body.begin(), extent_.body.end());
    if (extent_.has_words) appendWords(place.title, extent_.lines, halfWords(), out);
    for (const Which which : shown_) {
      const Eigen::Vector3d& middle = place.*centre(which);
      if (which == Which::world && extent_.momentum) {
        out.push_back({middle, kRound * unit_});
        out.push_back({middle + (kArrowReach - 0.15) * unit_ * *extent_.momentum, 0.15 * unit_});
      } else {
        out.push_back({middle, (which == Which::body ? kRound : kMovingReach) * unit_});
      }
      appendWords(middle - Eigen::Vector3d(0, 0, place.picture_title_depth), linesOf(which), halfWordsOf(place), out);
    }
  }

 private:
  static int linesOf(Which which) { return which == Which::body ? kPictureLines : 0; }

  /** Half the width of the words of the body, or of one of its pictures [heights of letters]. */
  double halfWords() const {
    return std::max(extent_.lines >= kFigures ? kHalfFigures : kHalfWords, kHalfLetter * extent_.letters);
  }
  double halfWordsOf(const BodyPlace& place) const {
    const int letters = place.titles == PictureTitles::named ? extent_.letters + kLettersOfPicture : 0;
    return std::max(kHalfWords, kHalfLetter * letters);
  }

  /** A title there, with lines below it. @param half the width of the words. */
  Box wordsBox(const Eigen::Vector3d& title, int lines, double half) const {
    Box out;
    const double letters = unit_ * text_;
    const double top = title.z() + 0.5 * letters * kTitleHeight,
                 height = letters * (kTitleHeight + kLineHeight * lines);
    out.add(title.y(), top - 0.5 * height, letters * half, 0.5 * height);
    return out;
  }

  void appendWords(const Eigen::Vector3d& title, int lines, double half, std::vector<Ball>& out) const {
    const Box box = wordsBox(title, lines, half);
    // Lines stand the nearer to the viewer the lower they are.
    const double nearer = title.z() - box.z0;
    for (const double y : {box.y0, box.y1}) out.push_back({{title.x() + nearer, y, box.z0}, 0});
  }

  const BodyExtent& extent_;
  double unit_, text_;
  std::vector<Which> shown_;
};

using Cells = std::vector<Cell>;

/** One way to set the pictures. */
struct Trial {
  std::vector<BodyPlace> places;
  bool together = false;  ///< away from their bodies
};

class Arranger {
 public:
  Arranger(const Cells& cells, double unit) : cells_(cells), unit_(unit) {}

  /** Pictures in a row with their bodies: to the right. Titles of one row are at one height. */
  Trial beside() const {
    Trial out = empty();
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const Cell& cell = cells_[i];
      BodyPlace& place = out.places[i];
      if (cell.shown().empty()) {
        place.title = cell.titleBeside();
      } else {
        place.title = cell.titleBelow(place.picture_title_depth);
        place.picture_title_depth = cell.start().z() - place.title.z();
      }
      setRow(cell, {cell.start().x(), cell.bodyBox(place).y1 + kGap * unit_, cell.start().z()}, place);
    }
    return out;
  }

  /** Pictures in a column to the right of their body: for one that flies up or down. */
  Trial stacked() const {
    Trial out = empty();
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const Cell& cell = cells_[i];
      BodyPlace& place = out.places[i];
      place.picture_title_depth += kGap * unit_;  // the lower picture is seen from farther above
      const Box body = cell.bodyBox(place);
      std::vector<Box> boxes;  // of each picture, about its middle
      double height = 0, left = 0;
      for (const Which which : cell.shown()) {
        boxes.push_back(cell.pictureBox(which, Eigen::Vector3d::Zero(), place));
        height += boxes.back().z1 - boxes.back().z0 + kGap * unit_;
        left = std::max(left, -boxes.back().y0);
      }
      double z = 0.5 * (body.z0 + body.z1 + height);
      for (std::size_t k = 0; k < boxes.size(); ++k) {
        place.*centre(cell.shown()[k]) = {cell.start().x(), body.y1 + kGap * unit_ + left, z - boxes[k].z1};
        z -= boxes[k].z1 - boxes[k].z0 + kGap * unit_;
      }
    }
    return out;
  }

  /** Pictures in a column with their bodies: below. Of one picture there is no more to say than the body's title. */
  Trial below() const {
    Trial out = empty();
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const Cell& cell = cells_[i];
      BodyPlace& place = out.places[i];
      if (cell.shown().size() == 1) place.titles = PictureTitles::none;
      double z = cell.bodyBox(place).z0 - kGap * unit_;
      for (const Which which : cell.shown()) {
        Eigen::Vector3d& middle = place.*centre(which);
        middle = cell.start();
        middle.z() = z - cell.reachOf(which).up;
        z = cell.pictureBox(which, middle, place).z0 - kGap * unit_;
      }
    }
    return out;
  }

  /** All pictures together to the right of all bodies, or below them, in a table with so many columns of bodies. */
  Trial together(bool to_the_right, std::size_t columns) const {
    Trial out = empty();
    out.together = true;
    Box bodies, largest;
    double depth = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      bodies.add(cells_[i].bodyBox(out.places[i]));
      depth += cells_[i].start().x() / static_cast<double>(cells_.size());
      BodyPlace& place = out.places[i];
      place.titles = PictureTitles::named;
      place.picture_title_depth += kGap * unit_;          // as in a column
      setRow(cells_[i], Eigen::Vector3d::Zero(), place);  // each cell begins at y = 0
      for (const Which which : cells_[i].shown()) {
        largest.add(cells_[i].pictureBox(which, place.*centre(which), place));
      }
    }
    const std::vector<std::size_t> order = inReadingOrder();
    const double width = largest.y1 - largest.y0 + kGap * unit_, height = largest.z1 - largest.z0 + kGap * unit_;
    const std::size_t row_count = (order.size() + columns - 1) / columns;
    const auto rows = static_cast<double>(row_count);
    const double left =
        to_the_right ? bodies.y1 + kGap * unit_ : 0.5 * (bodies.y0 + bodies.y1 - static_cast<double>(columns) * width);
    const double top = to_the_right ? 0.5 * (bodies.z0 + bodies.z1 + rows * height) : bodies.z0 - kGap * unit_;
    for (std::size_t k = 0; k < order.size(); ++k) {
      const Cell& cell = cells_[order[k]];
      BodyPlace& place = out.places[order[k]];
      const std::size_t column = k % columns, row = k / columns;
      const double y = left + static_cast<double>(column) * width - largest.y0;
      const double z = top - static_cast<double>(row) * height - largest.z1;
      setRow(cell, {depth, y, z}, place);
    }
    return out;
  }

  std::vector<Ball> ballsOf(const Trial& trial) const {
    std::vector<Ball> out;
    for (std::size_t i = 0; i < cells_.size(); ++i) cells_[i].appendBalls(trial.places[i], out);
    return out;
  }

  /** Whether no picture and no words meet anything of another body. Bodies that meet each other cannot be helped. */
  bool isClear(const Trial& trial) const {
    if (cells_.size() > kMostCompared) return false;
    std::vector<std::vector<Box>> all;  // of each body: itself, then its words and its pictures
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      const Cell& cell = cells_[i];
      const BodyPlace& place = trial.places[i];
      all.push_back({cell.bodyAlone(), cell.bodyBox(place)});
      for (const Which which : cell.shown()) {
        all.back().push_back(cell.pictureBox(which, place.*centre(which), place));
      }
    }
    const auto meet = [](const std::vector<Box>& one, const std::vector<Box>& other) {
      for (std::size_t a = 0; a < one.size(); ++a) {
        for (std::size_t b = 0; b < other.size(); ++b) {
          // The body with its words: only the words count where the bodies meet.
          const bool bodies_only = a + b == 0 || (a <= 1 && b <= 1 && one[0].meets(other[0]));
          if (!bodies_only && one[a].meets(other[b])) return true;
        }
      }
      return false;
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = i + 1; j < all.size(); ++j) {
        if (meet(all[i], all[j])) return false;
      }
    }
    return true;
  }

 private:
  /** Sets the pictures of a body in a row whose left end is there. */
  static void setRow(const Cell& cell, Eigen::Vector3d left_end, BodyPlace& place) {
    for (const Which which : cell.shown()) {
      place.*centre(which) = left_end + Eigen::Vector3d(0, cell.leftOf(which, place), 0);
      left_end.y() += cell.leftOf(which, place) + cell.rightOf(which, place);
    }
  }

  Trial empty() const {
    Trial out;
    for (const Cell& cell : cells_) {
      BodyPlace place;
      place.shows_world = cell.shows(Which::world);
      place.shows_body = cell.shows(Which::body);
      place.title = cell.titleBelow();
      place.picture_title_depth = cell.pictureTitleDepth();
      out.places.push_back(place);
    }
    return out;
  }

  /** Bodies from the left to the right, and those above each other from the top down. */
  std::vector<std::size_t> inReadingOrder() const {
    std::vector<std::size_t> out(cells_.size());
    std::iota(out.begin(), out.end(), 0);
    std::stable_sort(out.begin(), out.end(), [&](std::size_t a, std::size_t b) {
      const Eigen::Vector3d &p = cells_[a].start(), &q = cells_[b].start();
      return p.y() != q.y() ? p.y() < q.y() : p.z() > q.z();
    });
    return out;
  }

  const Cells& cells_;
  double unit_;
};

/** Sets what stands apart beyond the overview, so that no camera that shows that sees it. */
void standApart(const std::vector<BodyExtent>& bodies, SceneLayout& layout) {
  Box overview;
  for (const Ball& ball : layout.overview) overview.add(ball.centre.y(), ball.centre.z(), ball.radius, ball.radius);
  const double size = std::max(overview.y1 - overview.y0, overview.z1 - overview.z0);
  double y = overview.y1 + kApart * size;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    BodyPlace& place = layout.bodies[i];
    const double z = bodies[i].body.front().centre.z();
    if (!place.shows_world) {
      place.space_centre = {0, y, z};
      y += kApartSpacing * layout.unit;
    }
    if (!place.shows_body) {
      place.model_centre = {0, y, z};
      y += kApartSpacing * layout.unit;
    }
  }
}

double unitOf(const std::vector<BodyExtent>& bodies) {
  double unit = 0;
  for (const BodyExtent& body : bodies) unit = std::max(unit, body.radius);
  return unit > 0 && std::isfinite(unit) ? unit : 1;
}

/** Returns how many columns a table of so many bodies may have; of many bodies, one number that makes it nearly square.
 */
std::vector<std::size_t> columnsToTry(std::size_t bodies) {
  std::vector<std::size_t> out;
  if (bodies > kMostCompared) return {static_cast<std::size_t>(std::sqrt(static_cast<double>(bodies)))};
  for (std::size_t columns = 1; columns < bodies; columns *= 2) out.push_back(columns);
  if (bodies > 0) out.push_back(bodies);
  return out;
}

using Way = std::function<Trial(const Arranger&)>;

/** Returns the ways to set the pictures of so many bodies. */
std::vector<Way> waysFor(std::size_t with_pictures) {
  std::vector<Way> out = {&Arranger::beside, &Arranger::below, &Arranger::stacked};
  for (const std::size_t columns : columnsToTry(with_pictures)) {
    for (const bool to_the_right : {true, false}) {
      out.push_back([=](const Arranger& arranger) { return arranger.together(to_the_right, columns); });
    }
  }
  return out;
}

/** Returns the layout of that way, with letters that can be read in it. `distance`: how far off a camera is, or worse.
 */
SceneLayout layoutOf(const std::vector<BodyExtent>& bodies, const Way& way, double unit, double pitch,
                     double& distance) {
  SceneLayout out;
  out.unit = unit;
  out.pitch = pitch;
  // The letters change the picture, whose size decides on the letters.
  const int rounds = bodies.size() > kMostCompared ? 2 : kTextRounds;
  for (int i = 0; i < rounds; ++i) {
    if (i > 0) {
      const double height =
          2 * std::tan(0.5 * kFieldOfView) * cameraThatShows(out.overview, pitch, 0, 16.0 / 9).distance;
      out.text = std::clamp(kReadable * height / (kSmallestLetters * unit), kSmallest, kLargest);
    }
    Cells cells;
    for (const BodyExtent& body : bodies) cells.emplace_back(body, unit, out.text);
    const Arranger arranger(cells, unit);
    const Trial trial = way(arranger);
    out.bodies = trial.places;
    out.overview = arranger.ballsOf(trial);
    distance = cameraThatShows(out.overview, pitch, 0, kUsualAspect).distance;
    if (trial.together) {
      distance *= kTogetherIsWorse;
    } else if (!arranger.isClear(trial)) {
      distance *= kMeetingIsWorse;
    }
  }
  return out;
}

}  // namespace

SceneLayout sceneLayoutOf(const std::vector<BodyExtent>& bodies) {
  const double unit = unitOf(bodies), pitch = bodies.size() == 1 ? kPitch : kFlatPitch;
  const auto with_pictures = static_cast<std::size_t>(std::count_if(bodies.begin(), bodies.end(), [](const auto& body) {
    return body.shows_world || body.shows_body || body.shows_orbit;
  }));
  SceneLayout out;
  double least = std::numeric_limits<double>::infinity();
  for (const Way& way : waysFor(with_pictures)) {
    double distance = 0;
    SceneLayout layout = layoutOf(bodies, way, unit, pitch, distance);
    if (!(distance < least) && !out.bodies.empty()) continue;
    least = distance;
    out = std::move(layout);
  }
  standApart(bodies, out);
  return out;
}

}  // namespace poinsot::view
