#pragma once

#include <string>

/** Every topic, service, parameter, frame and marker name of the node. Other people's scripts rely on them. */
namespace poinsot::node::names {

// Topics, relative to the node's namespace; a body's are below its name.
inline constexpr const char* kState = "state";
inline constexpr const char* kOdometry = "odometry";
inline constexpr const char* kDescription = "description";
inline constexpr const char* kMarkers = "markers";
inline constexpr const char* kMarkersStatic = "markers_static";
inline constexpr const char* kClock = "/clock";
inline constexpr const char* kTf = "/tf";
inline constexpr const char* kTfStatic = "/tf_static";

// Services and topics, private.
inline constexpr const char* kStatus = "status";
inline constexpr const char* kPause = "pause";
inline constexpr const char* kStep = "step";
inline constexpr const char* kReset = "reset";
inline constexpr const char* kLoadScene = "load_scene";
inline constexpr const char* kSetMethod = "set_method";
inline constexpr const char* kSetSpin = "set_spin";
inline constexpr const char* kSpeed = "speed";
inline constexpr const char* kSeek = "seek";
inline constexpr const char* kViewpoint = "viewpoint";
inline constexpr const char* kLayout = "layout";
inline constexpr const char* kLightBackground = "light_background";
inline constexpr const char* kGrip = "grip";  // of an interactive marker server: grip/update, grip/feedback, …

// Parameters, private.
inline constexpr const char* kScene = "scene";
inline constexpr const char* kSceneFile = "scene_file";
inline constexpr const char* kRate = "rate";
inline constexpr const char* kPublishClock = "publish_clock";
inline constexpr const char* kFramePrefix = "frame_prefix";
inline constexpr const char* kMethod = "method";
inline constexpr const char* kMethodStep = "step";

// Frames.
inline constexpr const char* kWorld = "world";

inline std::string topic(const std::string& body, const char* name) {
  return body + "/" + name;
}

/** The frames of one body, prefix included. */
struct Frames {
  Frames(const std::string& prefix, const std::string& name)
      : body(prefix + name), space(body + "_space"), space_body(body + "_space_body"), model(body + "_model") {}
  std::string body;        ///< moving, below world
  std::string space;       ///< static: the picture in world axes
  std::string space_body;  ///< moving, below space: turns as the body does
  std::string model;       ///< static: the picture in body axes
};

// Marker namespaces: <body>/shape, <body>/space/omega, …
inline constexpr const char* kShape = "shape";
inline constexpr const char* kTrail = "trail";
inline constexpr const char* kLabel = "label";
inline constexpr const char* kTorque = "torque";
inline constexpr const char* kGravity = "gravity";
inline constexpr const char* kSpace = "space";
inline constexpr const char* kModel = "model";
inline constexpr const char* kEnergyEllipsoid = "energy_ellipsoid";
inline constexpr const char* kMomentumEllipsoid = "momentum_ellipsoid";
inline constexpr const char* kPolhode = "polhode";
inline constexpr const char* kSeparatrix = "separatrix";
inline constexpr const char* kOmega = "omega";
inline constexpr const char* kAngularMomentum = "angular_momentum";
inline constexpr const char* kHerpolhode = "herpolhode";
inline constexpr const char* kInvariablePlane = "invariable_plane";
inline constexpr const char* kMontgomery = "montgomery";
inline constexpr const char* kBodyCone = "body_cone";
inline constexpr const char* kSpaceCone = "space_cone";
inline constexpr const char* kPolhodeFamily = "polhode_family";
inline constexpr const char* kAxes = "axes";
inline constexpr const char* kPath = "path";
inline constexpr const char* kGhosts = "ghosts";
inline constexpr const char* kOrbit = "orbit";
// Of no body.
inline constexpr const char* kDrawnLine = "/line";
inline constexpr const char* kDrawnText = "/text";

inline std::string markers(const std::string& body, const char* what) {
  return body + "/" + what;
}
inline std::string markers(const std::string& body, const char* picture, const char* what) {
  return body + "/" + picture + "/" + what;
}

}  // namespace poinsot::node::names
