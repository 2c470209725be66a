// What a picture remembers from tick to tick.
#include <algorithm>

#include "drawn.h"
#include "poinsot/view/picture_frame.h"

namespace poinsot::node {
namespace {

scene::Body tumbling(double speed) {
  return Drawn::of(PrincipalInertia::fromMoments({1, 2, 3}), speed * Vector3d(0.3, 0.2, 1),
                   Eigen::Quaterniond::Identity());
}

/** Of a marker that is a line; 0 where it is not in the array [m]. */
double lengthOf(const MarkerArray& array, const std::string& ns) {
  double length = 0;
  for (const Marker& m : array.markers) {
    if (m.ns != ns || m.id != 0) continue;
    for (std::size_t i = 1; i < m.points.size(); ++i) length += (placed(m, i) - placed(m, i - 1)).norm();
  }
  return length;
}

TEST(BodyPicture, tellsLateViewersAllAlsoWhereStampsHaveJustBegun) {
  scene::Body body = tumbling(1);
  body.method = "rk4";
  body.step = 0.01;
  const session::MovingBody moving(body);
  BodyPicture picture(body, moving.motion(), names::Frames("", body.name), BodyPicture::Detail::pictures);
  const session::Tick tick{session::kSecond / 10, 0, 1, 0};
  const auto figures = [&] {
    MarkerArray out;
    picture.appendFigures(tick, {0, 0, 0, 0}, out);
    return out.markers.size();
  };
  EXPECT_EQ(figures(), 1U);
  EXPECT_EQ(figures(), 0U) << "a few times a second";
  picture.sendAllNext();
  EXPECT_EQ(figures(), 1U);
}

// A spin that is set may keep the frame of the one before. A trail that met itself would flicker.
TEST(BodyPicture, theTrailOfASlowerSpinInTheSameFrameDoesNotMeetItself) {
  const scene::Body fast = tumbling(1), slow = tumbling(0.5);
  const names::Frames frames("", slow.name);
  session::MovingBody moving(slow);
  const BodyPicture before(fast, session::MovingBody(fast).motion(), frames, BodyPicture::Detail::pictures);
  BodyPicture picture(slow, moving.motion(), frames, BodyPicture::Detail::pictures, before.frame());
  MarkerArray still, last;
  picture.appendStatic(still);
  for (int k = 0; k < 1000; ++k) {
    const session::Tick tick{(k + 1) * session::kSecond / 20, 0.05 * k, 1, 0};
    moving.move(tick);
    last.markers.clear();
    picture.appendMoving(tick, moving.motion(), moving.state(), last);
  }
  const double round = lengthOf(still, "body/model/polhode");
  EXPECT_LT(lengthOf(last, "body/trail"), 0.7 * round);
  EXPECT_GT(lengthOf(last, "body/trail"), 0.5 * round);
}

}  // namespace
}  // namespace poinsot::node
