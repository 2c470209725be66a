#include "poinsot/ros/markers/drawings.h"

#include <Eigen/Geometry>

#include "poinsot/ros/conversions.h"
#include "poinsot/ros/markers/palette.h"
#include "poinsot/ros/names.h"

namespace poinsot::node {
namespace {

using visualization_msgs::Marker;

// In radii of a picture.
constexpr double kLetters = 0.24;
constexpr double kWidth = 0.05;
constexpr double kHalfLetter = 0.28;  // of their height: half the width of one

std_msgs::ColorRGBA colourOf(const scene::Drawing& drawing) {
  if (!drawing.colour) return palette::kLabel;
  const Eigen::Vector3f c = drawing.colour->cast<float>();
  return palette::colour(c.x(), c.y(), c.z());
}

}  // namespace

void appendDrawings(const std::vector<scene::Drawing>& drawings, const view::SceneLayout& layout, bool light,
                    visualization_msgs::MarkerArray& out) {
  int id = 0;
  for (const scene::Drawing& drawing : drawings) {
    Marker m;
    m.header.frame_id = names::kWorld;
    m.id = id++;
    m.pose.orientation.w = 1;
    const bool is_text = !drawing.words.empty();
    m.ns = is_text ? names::kDrawnText : names::kDrawnLine;
    m.type = is_text ? Marker::TEXT_VIEW_FACING : Marker::LINE_STRIP;
    m.color = is_text ? palette::asText(colourOf(drawing), light) : colourOf(drawing);
    if (is_text) {
      m.text = drawing.words;
      m.scale.z = kLetters * layout.unit * layout.text;
      m.pose.position = toPoint(drawing.points.front());
    } else {
      m.scale.x = kWidth * layout.unit;
      for (const Eigen::Vector3d& point : drawing.points) m.points.push_back(toPoint(point));
    }
    out.markers.push_back(m);
  }
}

void extendOverview(const std::vector<scene::Drawing>& drawings, view::SceneLayout& layout) {
  const double height = kLetters * layout.unit * layout.text;
  for (const scene::Drawing& drawing : drawings) {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& point : drawing.points) box.extend(point);
    const auto letters = static_cast<double>(scene::lettersOf(drawing.words));
    const Eigen::Vector3d half(0, kHalfLetter * height * letters, 0);
    layout.overview.push_back({box.min() - half, 0.6 * height});
    layout.overview.push_back({box.max() + half, 0.6 * height});
  }
}

}  // namespace poinsot::node
