#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "poinsot/core/motion.h"
#include "poinsot/scene/scene.h"
#include "poinsot/session/request.h"

namespace poinsot::session {

/** A scene, and where it came from. */
struct NamedScene {
  scene::Scene scene;
  std::string name, file;  ///< empty where there is none
};

/** Reads a scene file, on the job's thread. Throws std::exception with what is wrong with it. */
using ReadScene = std::function<NamedScene(const std::string&)>;

/** The scene as it is to be once all that was asked for is done. */
struct Draft : NamedScene {
  scene::Scene start_scene;      ///< as a reset is to bring it back
  std::set<std::size_t> bodies;  ///< to be made anew
  bool all = false;              ///< another scene: no body stays
  bool from_start = false;       ///< at t = 0
  bool redraw = false;           ///< pictures are laid out anew
  bool reset = false;            ///< a reset is part of it
  std::optional<double> seek;    ///< where t is to go when it is done [s]
  std::vector<Request> requests;
};

/** A request that changes bodies, with what was true when it was asked for. */
struct Asked {
  Request request;
  double coming_time = 0;  ///< SetMethod: at which it would begin to play, unless something begins at t = 0 [s]
  MotionState state;       ///< SetSpin: of the body
};

/** Returns the index of a body in a scene. Throws scene::Error, with the names of the scene's bodies. */
std::size_t indexOf(const scene::Scene& scene, const std::string& body);

/** Returns whether some body starts differently in two scenes with the same bodies. */
bool startsDiffer(const scene::Scene& scene, const scene::Scene& start_scene);

/**
 * Changes the draft as a LoadScene, SetMethod, SetSpin, Reset or Seek asks.
 * @param read for LoadScene.
 * Throws std::exception with what is wrong with the request; then the draft is as it was.
 */
Answer apply(const Asked& asked, Draft& draft, const ReadScene& read);

/** Returns why a body under a stepper does not go to t = `time` [s]. */
std::string tooManySteps(const std::string& body, double time, double steps, double step);

}  // namespace poinsot::session
