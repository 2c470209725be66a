#pragma once

#include <string>

#include "poinsot/core/step_limits.h"
#include "poinsot/scene/scene.h"

namespace poinsot::scene {

/** Whether a body's method and step are sound, and what messages say of them otherwise. */
struct StepVerdict {
  StepJudgement::Grade grade = StepJudgement::Grade::sound;
  std::string problem;       ///< what is wrong with method and step at |Omega|; empty when sound
  std::string instead;       ///< what is expected instead; empty when sound
  double largest_sound = 0;  ///< a step [s] that is sound, to two digits; 0 when none was found
};

/** Returns the verdict. @param body has a stepper as its method, and a step. */
StepVerdict verdictOnStep(const Body& body);

}  // namespace poinsot::scene
