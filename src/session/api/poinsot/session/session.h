#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "poinsot/session/body.h"
#include "poinsot/session/build.h"
#include "poinsot/session/clock.h"
#include "poinsot/session/draft.h"
#include "poinsot/session/job.h"
#include "poinsot/session/listener.h"
#include "poinsot/session/spin_drag.h"
#include "poinsot/session/status.h"

namespace poinsot::session {

inline constexpr double kMostLoad = 0.8;  ///< of one core, for what a speed may ask of the steppers

/**
 * What plays: bodies that move with a clock, and requests to change them. One thread uses it; its job does what takes
 * long, which takes effect in serve().
 *
 * Requests that come while others are being worked out are worked out together with them: the session keeps one draft
 * of the scene as it is to be, and builds anew the bodies in which it differs from what plays. A request that is wrong
 * in itself is refused alone; where the bodies cannot be built, all requests of the draft are refused.
 */
class Session {
 public:
  struct Options {
    double rate = scene::kDefaultRate;  ///< of the ticks [Hz]
    /** The file that a name or a path stands for. Throws std::exception where there is none. */
    std::function<std::string(const std::string& name_or_path)> find;
    ReadScene read;
    /** Called in the session's thread: what makes companions for bodies that take the places of others. */
    std::function<MakeCompanion(const std::vector<const Body*>& replaced, Redraw redraw)> companions;
  };
  using Reply = std::function<void(const Answer&)>;

  /**
   * Plays what was built, from t = 0.
   * @param scene with the scene as it was built, for a reset as well.
   * @param job, listener outlive the session.
   */
  Session(const Options& options, const NamedScene& scene, Built&& built, Job& job, Listener& listener);

  /** Carries a request out, or begins to. @param reply is called once, now or in serve(). */
  void ask(const Request& request, const Reply& reply = {});

  /**
   * Takes what a hand did.
   * @param now by the wall's clock; eye: of the viewer [m, world axes], where it is known.
   * @param frame the frame in which points must be.
   */
  void touch(const HandleEvent& event, Nanoseconds now, const std::optional<Eigen::Vector3d>& eye,
             const std::string& frame);

  /** Takes what the job has done and gives it more; lets go for hands that are gone. @param now by the wall's clock. */
  void serve(Nanoseconds now);

  /**
   * Moves all bodies to the time at this stamp; nothing where the stamp repeats. Throws std::runtime_error when a body
   * has no state there.
   */
  std::optional<Tick> tick(Nanoseconds stamp);

  const Clock& clock() const { return clock_; }
  const Bodies& bodies() const { return bodies_; }
  const scene::Scene& scene() const { return playing_.scene; }
  /** Returns a body as it is to be drawn: while somebody holds it, as it would start there. */
  Body& drawn(std::size_t i) const;
  const Body* preview() const { return preview_.get(); }
  const SpinDrag& drag() const { return drag_; }

  /** Of all bodies together, by their steps [CPU s per simulated s]. */
  double steppingCost() const { return session::steppingCost(bodies_); }
  Status status() const;

 private:
  // Requests that take effect at the next tick.
  Answer pause(bool paused);
  Answer step();
  Answer setSpeed(const SetSpeed& request);
  Answer resetNow();
  /** Jumps to a time at the next tick, where that takes few steps; else as soon as the job has stepped there. */
  Answer seek(double time);
  void jumpTo(double time);
  /** Where the scene plays in rounds and one ends before this stamp: jumps to the beginning of the next. */
  void beginNextRound(Nanoseconds stamp);
  Answer refuse(Refusal refusal);
  Answer refuse(const Request& request, const std::string& detail);

  // Requests that change bodies.
  bool loading() const;
  Draft present() const;
  void enqueue(const Request& request, const Reply& reply);
  std::vector<Asked> allAsked() const;
  void takeAnswers(Prepared&& prepared);
  void build();
  double comingTime() const;
  void startNext();
  void startPreparing();
  void startSeeking();
  void takeOutcome();
  /** Ends what the job does; its outcome will not be used. */
  void dropWork();
  void takeBuilt(Built&& built);
  std::optional<Refusal> tooCostly(const Built& built) const;
  void giveUpDraft(Refusal refusal);
  void exchange(Built&& built);
  void stopSeeking();

  // A hand on a body's spin.
  void handle(const HandleEvent& event, Nanoseconds now, const std::optional<Eigen::Vector3d>& eye,
              const std::string& frame);
  void press(const Body& body, Nanoseconds now);
  void lead(const HandleEvent& event, Nanoseconds now, const std::optional<Eigen::Vector3d>& eye,
            const std::string& frame);
  void letGo();
  void choose(const HandleEvent& event);
  void endDrag();

  /** What the job does. */
  struct Work {
    enum class Kind { none, preparing, building, seeking };
    Kind kind = Kind::none;
    bool stale = false;     ///< its outcome is not to be used: something else was asked for since
    std::size_t asked = 0;  ///< preparing: how many requests, from the first in the queue on
  };
  struct Waiting {
    Asked asked;
    Reply reply;
  };

  Options options_;
  Job& job_;
  Listener& listener_;
  Clock clock_;
  Bodies bodies_;
  NamedScene playing_;
  scene::Scene start_scene_;    ///< as a reset brings it back
  std::vector<Waiting> queue_;  ///< asked for and not yet applied to the draft
  std::optional<Draft> draft_;  ///< the scene as it is to be, where it is to be another
  std::optional<double> seek_;  ///< to which the job steps what plays, or is to [s]
  Work work_;
  std::optional<Refusal> refusal_;
  SpinDrag drag_;
  view::ConservedQuantity keep_ = view::ConservedQuantity::energy;
  std::unique_ptr<Body> preview_;  ///< of the body that is held: as it would start from where it was led
};

/** Returns the place where Ω is drawn, in the picture in body axes [m]. */
Eigen::Vector3d omegaPoint(const Body& body);

}  // namespace poinsot::session
