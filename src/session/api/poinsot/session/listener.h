#pragma once

#include <string>
#include <vector>

#include "poinsot/session/request.h"
#include "poinsot/view/spin_choices.h"

namespace poinsot::session {

/** Is told what happens in a session, in the session's thread and from inside its functions. */
class Listener {
 public:
  virtual ~Listener() = default;

  /** Other bodies play now: those of another scene, or some of the present one, which have these names. */
  virtual void bodiesChanged(const std::vector<std::string>& names, bool another_scene) = 0;
  /** A body that is held would start from somewhere else. */
  virtual void previewChanged(const std::string& body) = 0;
  /** A body that was held is drawn as before again. */
  virtual void previewEnded(const std::string& body) = 0;
  /** Spins are led on that ellipsoid from now on. */
  virtual void keepsAnotherEllipsoid(view::ConservedQuantity keep) = 0;

  virtual void refused(const Refusal& refusal) = 0;
  virtual void warned(const std::string& warning) = 0;
  virtual void chose(const std::string& choice) = 0;
  /** It takes this many steps to get there; what plays goes on meanwhile. */
  virtual void seeksFar(double time, double steps) = 0;
  /** Doubles lie `spacing` [s] apart at `time`, so that time visibly jumps. */
  virtual void timeIsCoarse(double time, double spacing) = 0;
  /** The hand on this body has not been heard of for long. */
  virtual void handIsGone(const std::string& body) = 0;

  /** The stamps have jumped back: a new segment begins. */
  virtual void stampsJumpedBack() = 0;
  /** The stamps have jumped ahead by more than can be stepped at once [s]: t goes on as before, in a new segment. */
  virtual void stampsJumpedAhead(double by) = 0;
  /** t would leave the range of doubles: it is paused. */
  virtual void timeLeftTheRange(double time, double speed) = 0;
};

}  // namespace poinsot::session
