#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/core/invariants.h"
#include "poinsot/session/request.h"
#include "poinsot/view/flips.h"
#include "poinsot/view/polhode.h"

namespace poinsot::session {

/** The free motion of a body. */
struct FreeMotion {
  view::Regime regime = view::Regime::rest;
  Eigen::Vector3d omega_principal = Eigen::Vector3d::Zero();  ///< at its start [rad/s]: which axis a steady spin has
  Eigen::Vector3d moments = Eigen::Vector3d::Zero();          ///< principal [kg·m²]
  bool beside_separatrix = false;                             ///< too near to it for doubles to tell on which side
  view::Flips flips;
};

/** What moves one body now. */
struct BodyStatus {
  std::string name, method;
  std::optional<double> step;        ///< [s]
  std::vector<std::string> methods;  ///< that can move it
  /** Of the body as it is drawn: while it is held, of the motion that would begin there. Nothing under torques. */
  std::optional<FreeMotion> free;
  std::optional<Invariants> held;  ///< while its spin is dragged: of the motion that would begin there
};

/** What a session is doing. */
struct Status {
  std::string scene, file;
  double time = 0;  ///< t [s]
  std::uint32_t segment = 0;
  bool paused = false;
  double speed = 1;
  std::vector<Request> activities;  ///< what is being worked out
  std::optional<Refusal> refusal;   ///< the last, until something else was done
  std::vector<BodyStatus> bodies;
};

}  // namespace poinsot::session
