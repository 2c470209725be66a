#pragma once

#include <functional>
#include <memory>

#include "poinsot/core/motion.h"
#include "poinsot/scene/scene.h"
#include "poinsot/view/picture_frame.h"

namespace poinsot::session {

/** What belongs to a body outside of the session: its picture, and its publishers. */
class Companion {
 public:
  virtual ~Companion() = default;
  /** How the body's picture stands and how large it is; with it the place of a hand becomes a spin. */
  virtual const view::PictureFrame& frame() const = 0;
};

/** Makes the companion of a body. Called on the thread of the background job, so it must own what it uses, or share
 * only what is safe for threads. */
using MakeCompanion = std::function<std::unique_ptr<Companion>(const scene::Body&, const Motion&)>;

/** How a body that takes another's place is drawn. */
enum class Redraw {
  never,               ///< exactly as the other was
  where_it_has_to_be,  ///< as the other was, unless it would be far too small or too large
  always               ///< laid out anew
};

}  // namespace poinsot::session
