#pragma once

#include <string>
#include <vector>

#include "poinsot/session/request.h"
#include "poinsot/view/spin_choices.h"

namespace poinsot::session {

/** Who is told what happens in a session. Called in the session's thread, from inside its functions. */
class Listener {
 public:
  virtual ~Listener() = default;

  /** Other bodies play now: those of another scene, or some of the present one, which have these names. */
  virtual void bodiesChanged(const std::vector<std::string>& names, bool another_scene) = 0;
  /** A body that is held would start from somewhere else. */
  virtual void previewChanged(const std::string& body) = 0;
  /** It looks again as it was before. */
  virtual void previewEnded(const std::string& body) = 0;
  /** Spins are led on that ellipsoid from now on. */
  virtual void keepsAnotherEllipsoid(view::ConservedQuantity keep) = 0;

  virtual void refused(const Refusal& refusal) = 0;
  virtual void warned(const std::string& warning) = 0;
  virtual void chose(const std::string& choice) = 0;
  /** It takes this many steps to get there; what plays goes on meanwhile. */
  virtual void seeksFar(double time, double steps) = 0;
  /** Doubles lie so far apart there that time is seen to jump. */
  virtual void timeIsCoarse(double time, double spacing) = 0;
  virtual void handIsGone(const std::string& body) = 0;

  /** The stamps have jumped back: a new segment begins. */
  virtual void stampsJumpedBack() = 0;
  /** Further at once than can be stepped [s]: t goes on from where it was, in a new segment. */
  virtual void stampsJumpedAhead(double by) = 0;
  /** Doubles end: paused there. */
  virtual void timeLeftTheRange(double time, double speed) = 0;
};

}  // namespace poinsot::session
