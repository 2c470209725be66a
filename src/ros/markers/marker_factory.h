#pragma once

#include <visualization_msgs/Marker.h>

#include <Eigen/Core>
#include <string>
#include <utility>

#include "poinsot/ros/markers/palette.h"
#include "poinsot/ros/names.h"
#include "poinsot/view/curve.h"

namespace poinsot::node {

/** Ids within <body>/label and, of names that belong to arrows in world axes, <body>/space/label. */
enum LabelId {
  kBodyTitle,
  kSpaceTitle,
  kModelTitle,
  kMomentumSymbol,
  kOmegaPointer,
  kOmegaSymbol,
  kModelOmegaSymbol,
  kFigures,
  kTorqueSymbol,
  kTorqueAtMomentumSymbol,
  kWeightSymbol,
  kOrbitSymbol,
  kFlips,
  kTurn,
  kEnergyName,
  kMomentumName,
  kOrbitTitle,
  kOmegaEnd
};
constexpr int kLabelIds = kOmegaEnd + 1;
constexpr int kTrailIds = 65;  ///< in <body>/trail: the newest stretch, and 64 pieces of a path under torques
constexpr int kCurveIds = 4;   ///< of a polhode and of a separatrix: their branches

/** Makes markers of one body, in its namespaces and its frames; stamps 0. */
class MarkerFactory {
 public:
  MarkerFactory(std::string body, names::Frames frames) : body_(std::move(body)), frames_(std::move(frames)) {}

  const names::Frames& frames() const { return frames_; }
  std::string ns(const char* what) const { return names::markers(body_, what); }
  std::string ns(const char* picture, const char* what) const { return names::markers(body_, picture, what); }
  std::string ns(LabelId id) const;

  /** @param scale the sides of the box around it [m]; {width, 0, 0} of lines, {1, 1, 1} of triangles. */
  visualization_msgs::Marker marker(const std::string& ns, int id, int type, const std::string& frame,
                                    const Eigen::Vector3d& scale, const std_msgs::ColorRGBA& colour) const;
  /** A curve, locked. @param metres per unit of its points. @param diameter of one that is a single point [m]. */
  visualization_msgs::Marker curve(const std::string& ns, int id, const std::string& frame, const view::Curve& curve,
                                   double metres, double width, double diameter,
                                   const std_msgs::ColorRGBA& colour) const;
  visualization_msgs::Marker text(LabelId id, const std::string& frame, const Eigen::Vector3d& place,
                                  const std::string& words, double height,
                                  const std_msgs::ColorRGBA& colour = palette::kLabel) const;
  visualization_msgs::Marker arrow(const std::string& ns, int id, const std::string& frame, const Eigen::Vector3d& from,
                                   const Eigen::Vector3d& tip, const std_msgs::ColorRGBA& colour) const;

 private:
  std::string body_;
  names::Frames frames_;
};

/** For what does not move in its frame: RViz takes it along with that. */
visualization_msgs::Marker locked(visualization_msgs::Marker marker);

/** The same brightness from all sides: RViz lights no triangles that have colours of their own. */
void makeUnlit(visualization_msgs::Marker& triangles);

}  // namespace poinsot::node
