#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Core>
#include <string>

#include "poinsot/ros/names.h"

namespace poinsot::node {

// Lengths in metres; a picture's ellipsoids reach 1 m.
constexpr double kShaft = 0.045;
constexpr double kHead = 0.115;
constexpr double kHeadLength = 0.17;
constexpr double kTitleHeight = 0.21;
constexpr double kSymbolHeight = 0.23;
constexpr double kSeparatrixWidth = 0.012;
constexpr double kPolhodeLift = 1.010;  // off the surface that it runs on, so as not to sink into it

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
  kTurn
};
constexpr int kLabelIds = kTurn + 1;
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

  visualization_msgs::Marker marker(const std::string& ns, int id, int type, const std::string& frame) const;
  visualization_msgs::Marker text(LabelId id, const std::string& frame, const Eigen::Vector3d& place,
                                  const std::string& words, double height) const;
  visualization_msgs::Marker arrow(const std::string& ns, int id, const std::string& frame, const Eigen::Vector3d& from,
                                   const Eigen::Vector3d& tip) const;

 private:
  std::string body_;
  names::Frames frames_;
};

/** The same brightness from all sides: RViz lights no triangles that have colours of their own. */
void makeUnlit(visualization_msgs::Marker& triangles);

}  // namespace poinsot::node
