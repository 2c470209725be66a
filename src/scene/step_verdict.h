#pragma once

#include <string>

#include "poinsot/core/step_limits.h"
#include "poinsot/scene/scene.h"

namespace poinsot::scene {

/** What is to be said of a body's method and step. */
struct StepVerdict {
  StepJudgement::Grade grade = StepJudgement::Grade::sound;
  std::string problem;       ///< what is wrong, with method, step and |Omega|; empty when sound
  std::string instead;       ///< what is allowed instead
  double largest_sound = 0;  ///< a step [s] that is sound, to two digits; 0 when none was found
};

/** @param body whose method is a stepper and has its step. */
StepVerdict verdictOnStep(const Body& body);

}  // namespace poinsot::scene
