// Where pictures stand: clear of all bodies and of each other, whatever the scene; letters that can be read.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "poinsot/view/scene_layout.h"

namespace poinsot::view {
namespace {

BodyExtent bodyAt(const Eigen::Vector3d& place, double radius) {
  BodyExtent out;
  out.body = {{place, radius}};
  out.radius = radius;
  out.momentum = Eigen::Vector3d::UnitZ();
  return out;
}

/** Everything that is drawn, as discs for a viewer at +x: of body i, itself and then its pictures. */
std::vector<std::vector<Ball>> discsOf(const std::vector<BodyExtent>& bodies, const SceneLayout& layout) {
  std::vector<std::vector<Ball>> out;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    out.push_back(bodies[i].body);
    for (const Eigen::Vector3d& centre : {layout.bodies[i].space_centre, layout.bodies[i].model_centre}) {
      out.back().push_back({centre, layout.unit});
    }
  }
  return out;
}

double distanceSeen(const Ball& a, const Ball& b) {
  return (a.centre - b.centre).tail<2>().norm() - a.radius - b.radius;
}

/** The least distance from a picture to anything else, in radii of a picture. */
double leastGap(const std::vector<BodyExtent>& bodies, const SceneLayout& layout) {
  const auto discs = discsOf(bodies, layout);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t j = 0; j < discs.size(); ++j) {
      for (std::size_t a = bodies[i].body.size(); a < discs[i].size(); ++a) {
        for (std::size_t b = 0; b < discs[j].size(); ++b) {
          if (i != j || a != b) least = std::min(least, distanceSeen(discs[i][a], discs[j][b]));
        }
      }
    }
  }
  return least / layout.unit;
}

/** The least distance from the tip of an L to what is drawn of another body, in radii of a picture. */
double leastGapOfTips(const std::vector<BodyExtent>& bodies, const SceneLayout& layout) {
  const auto discs = discsOf(bodies, layout);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!bodies[i].momentum) continue;
    const Ball tip{layout.bodies[i].space_centre + 1.45 * layout.unit * *bodies[i].momentum, 0};
    for (std::size_t j = 0; j < discs.size(); ++j) {
      for (const Ball& disc : discs[j]) {
        if (i != j) least = std::min(least, distanceSeen(tip, disc));
      }
    }
  }
  return least / layout.unit;
}

TEST(SceneLayout, oneBodyHasItsPicturesToItsRight) {
  const SceneLayout layout = sceneLayoutOf({bodyAt({0, 0, 0}, 0.7)});
  const BodyPlace& place = layout.bodies.front();
  EXPECT_GT(place.space_centre.y(), 0.7 + layout.unit);
  EXPECT_GT(place.model_centre.y(), place.space_centre.y() + 2 * layout.unit);
  EXPECT_EQ(place.space_centre.z(), 0);
  EXPECT_EQ(layout.unit, 0.7) << "as large as the body";
}

TEST(SceneLayout, bodiesSideBySideHaveThemBelow) {
  std::vector<BodyExtent> bodies;
  for (const double y : {-2.6, 0.0, 2.6}) {
    bodies.push_back(bodyAt({0, y, 0}, 0.9));
    bodies.back().shows_world = false;
  }
  const SceneLayout layout = sceneLayoutOf(bodies);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    EXPECT_EQ(layout.bodies[i].model_centre.y(), bodies[i].body.front().centre.y());
    EXPECT_LT(layout.bodies[i].model_centre.z(), -1.8);
    EXPECT_EQ(layout.bodies[i].titles, PictureTitles::none) << "one caption a column";
  }
}

TEST(SceneLayout, noPictureMeetsAnything) {
  std::mt19937_64 engine(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 400; ++i) {
    std::vector<BodyExtent> bodies;
    const double size = std::pow(10, 3 * unit(engine));
    const std::size_t count = 1 + engine() % 9;
    for (std::size_t k = 0; k < count; ++k) {
      const Eigen::Vector3d place(unit(engine), 4 * unit(engine), 4 * unit(engine));
      bodies.push_back(bodyAt(size * place, size * (0.05 + std::abs(unit(engine)))));
      bodies.back().shows_world = engine() % 2 == 0;
      bodies.back().momentum = Eigen::Vector3d(unit(engine), unit(engine), unit(engine)).normalized();
      if (engine() % 3 == 0) bodies.back().momentum = std::nullopt;
      for (int step = 1; engine() % 4 == 0 && step < 8; ++step) {
        bodies.back().body.push_back({size * (place + 0.3 * step * Eigen::Vector3d::UnitZ()), bodies.back().radius});
      }
    }
    const SceneLayout layout = sceneLayoutOf(bodies);
    EXPECT_GT(leastGap(bodies, layout), 0.1) << "scene " << i;
    EXPECT_GT(leastGapOfTips(bodies, layout), 0.1) << "an arrow of L, scene " << i;
  }
}

TEST(SceneLayout, threeBricksOfANewcomer) {  // where pictures beside each body would stand in its neighbours
  std::vector<BodyExtent> bodies;
  for (const double y : {-4.0, 0.0, 4.0}) bodies.push_back(bodyAt({0, y, 0}, 1.8));
  EXPECT_GT(leastGap(bodies, sceneLayoutOf(bodies)), 0.1);
}

TEST(SceneLayout, aPictureInTheWayIsSeenToBe) {  // so that the tests above can fail
  const std::vector<BodyExtent> bodies = {bodyAt({0, 0, 0}, 1), bodyAt({0, 9, 0}, 1)};
  SceneLayout layout = sceneLayoutOf(bodies);
  layout.bodies[0].model_centre = {0, 8, 0};
  EXPECT_LT(leastGap(bodies, layout), 0);
}

TEST(SceneLayout, allLengthsGrowWithTheBodies) {
  for (const double size : {0.15, 15.0}) {
    const SceneLayout one = sceneLayoutOf({bodyAt({0, 0, 0}, 1)}), other = sceneLayoutOf({bodyAt({0, 0, 0}, size)});
    EXPECT_TRUE(other.bodies[0].model_centre.isApprox(size * one.bodies[0].model_centre, 1e-12));
    EXPECT_TRUE(other.bodies[0].title.isApprox(size * one.bodies[0].title, 1e-12));
    EXPECT_NEAR(other.text, one.text, 1e-9);
  }
}

TEST(SceneLayout, lettersCanBeReadInLargeScenes) {
  std::vector<BodyExtent> bodies;
  for (int i = 0; i < 6; ++i) bodies.push_back(bodyAt({0, 5.0 * i, 0}, 1));
  const SceneLayout layout = sceneLayoutOf(bodies);
  const double height =
      2 * std::tan(0.5 * kFieldOfView) * cameraThatShows(layout.overview, layout.pitch, 0, 16.0 / 9).distance;
  EXPECT_GE(0.17 * layout.text * layout.unit / height * 450, 11) << "pixels, in a picture of 800 x 450";
}

TEST(SceneLayout, whatStandsApartIsNotSeen) {
  BodyExtent top = bodyAt({0, 0, 0}, 1);
  top.shows_world = top.shows_body = false;
  const SceneLayout layout = sceneLayoutOf({top});
  const OrbitCamera camera = cameraThatShows(layout.overview, layout.pitch, 0, 2.4);
  const double half_width = 2.4 * std::tan(0.5 * kFieldOfView) * camera.distance;
  for (const Eigen::Vector3d& centre : {layout.bodies[0].space_centre, layout.bodies[0].model_centre}) {
    EXPECT_GT(centre.y() - camera.focal.y() - layout.unit, half_width);
  }
}

TEST(SceneLayout, aThousandBodiesHaveTheirPicturesTogether) {
  std::vector<BodyExtent> bodies;
  for (int i = 0; i < 1000; ++i) bodies.push_back(bodyAt({0, 3.0 * (i % 40), 3.0 * (i / 40)}, 1));
  const SceneLayout layout = sceneLayoutOf(bodies);
  ASSERT_EQ(layout.bodies.size(), 1000u);
  EXPECT_GT(leastGap(bodies, layout), 0.1);
}

TEST(SceneLayout, isThereForAnyScene) {
  EXPECT_EQ(sceneLayoutOf({bodyAt({0, 1e9, 0}, 1), bodyAt({0, -1e9, 0}, 1e-9)}).bodies.size(), 2u);
  EXPECT_EQ(sceneLayoutOf({bodyAt({0, 0, 0}, 0)}).bodies.size(), 1u);
  EXPECT_TRUE(sceneLayoutOf({}).bodies.empty());
}

}  // namespace
}  // namespace poinsot::view
