#pragma once

#include <ros/node_handle.h>

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/ros/body.h"
#include "poinsot/scene/scene.h"

namespace poinsot::node {

/** Why a body under a stepper does not go to t = `time` [s], in words. */
std::string tooManySteps(const std::string& body, double time, double steps, double step);

/** Makes bodies of a scene anew on a thread of its own, so that what plays goes on meanwhile. */
class Rebuild {
 public:
  struct Order {
    scene::Scene scene;               ///< as it is to be; accuracies are still to be met by a method and a step
    std::vector<std::size_t> bodies;  ///< which of the scene's bodies to make
    std::vector<std::optional<PictureFrame>> keep;  ///< for each of them: how it is drawn now, kept where it still fits
    double time = 0;                                ///< at which they are to be ready to be moved on from [s]
    double rate = scene::kDefaultRate;              ///< of the ticks [Hz]
    std::string frame_prefix;
  };
  struct Result {
    scene::Scene scene;  ///< settled
    std::vector<std::size_t> indices;
    std::vector<std::unique_ptr<Body>> bodies;  ///< for each index
    std::vector<std::string> said;              ///< what was chosen for accuracies
  };

  Rebuild() = default;
  Rebuild(const Rebuild&) = delete;
  Rebuild& operator=(const Rebuild&) = delete;
  ~Rebuild();

  /** Starts, when not busy. */
  void start(Order order, const ros::NodeHandle& handle);
  /** Moves what was made on to another time, when not busy: to be polled like what start() makes. */
  void goOn(Result made, double time);
  bool busy() const { return work_.valid(); }
  /** Makes it end soon; what it was doing is then of no use, but still to be polled. */
  void cancel() { cancelled_ = true; }

  /** The result, once, when it is there. Throws std::exception, once, with the reason why there is none. */
  std::optional<Result> poll();

 private:
  std::atomic<bool> cancelled_{false};
  std::future<Result> work_;
};

}  // namespace poinsot::node
