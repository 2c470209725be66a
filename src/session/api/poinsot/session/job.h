#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "poinsot/core/motion.h"
#include "poinsot/scene/scene.h"
#include "poinsot/session/body.h"
#include "poinsot/session/draft.h"

namespace poinsot::session {

/** Requests that were applied to a draft, each with its answer. */
struct Prepared {
  Draft draft;
  std::vector<Answer> answers;
};

/** Bodies that are ready to play. */
struct Built {
  scene::Scene scene;  ///< with a method and a step for every body that was built
  std::vector<std::size_t> indices;
  Bodies bodies;                     ///< for each index
  std::vector<std::string> choices;  ///< in words: what was chosen for accuracies
};

/** Motions of all bodies that have been stepped to a time [s]. */
struct Advanced {
  double time = 0;
  std::vector<Motion> motions;
};

using Outcome = std::variant<Prepared, Built, Advanced>;

/** What a job does. Throws std::exception; cost::Cancelled soon after `cancelled` has become true. */
using Work = std::function<Outcome(const std::atomic<bool>& cancelled)>;

/** Does one piece of work at a time, beside the thread that asks for it. */
class Job {
 public:
  virtual ~Job() = default;
  /** Starts; only when it is not busy. */
  virtual void start(Work work) = 0;
  /** Until poll() has given the outcome. */
  virtual bool busy() const = 0;
  /** Makes it end soon. Its outcome is still to be polled. */
  virtual void cancel() = 0;
  /** The outcome, once, when it is there. Throws, once, what the work threw. */
  virtual std::optional<Outcome> poll() = 0;
};

}  // namespace poinsot::session
