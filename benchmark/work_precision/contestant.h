#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

/** What takes part in work_precision: Poinsot's own methods and other people's solvers, all asked the same things. */
namespace poinsot::work_precision {

/** A free body, principal axes. */
struct Problem {
  std::string body;                                              ///< its name in the tables
  Eigen::Vector3d moments = Eigen::Vector3d::Ones();             ///< [kg·m²]
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();  ///< at t = 0, body → world, unit
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();               ///< at t = 0 [rad/s], body axes
};

/** What a contestant answers for one time. As it comes: the attitude is normalised only if the solver does so itself.
 */
struct Answer {
  double time = 0;       ///< [s]
  double time_rest = 0;  ///< what rounding took off the time that is meant [s]
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();  ///< body axes

  Answer() = default;
  Answer(double at, const Eigen::Quaterniond& q, const Eigen::Vector3d& o) : time(at), attitude(q), omega(o) {}
};

/** What a run took. */
struct Effort {
  static constexpr std::int64_t kUnknown = -1;
  std::int64_t steps = 0;               ///< of the solver, those it rejected included
  std::int64_t evaluations = kUnknown;  ///< of the right-hand side, or of the equation that an implicit method solves
  std::int64_t exponentials = 0;        ///< of SO(3)
};

/** Called with what the solver holds after a step of its own, at least 200 times in a run of more steps. */
using Watch = std::function<void(const Answer&)>;

/** A solver made ready for one problem at one setting. All that a user would do once for a body is done; what depends
 * on the start or the horizon is part of a run. */
class Run {
 public:
  virtual ~Run() = default;

  /**
   * From the start to `horizon` > 0 by the solver's own steps; returns the state at exactly `horizon`.
   * @param watch called after steps, where it is set. Timed runs have none: then nothing is paid for it in the loop.
   */
  virtual Answer shot(double horizon, const Watch& watch, Effort& effort) = 0;

  /**
   * The states at t = interval, 2·interval, … count·interval, into `out`, which has room for them, as the solver gives
   * them best: dense output where it has one, else steps that hit the times.
   */
  virtual void ticks(double interval, std::int64_t count, Answer* out, Effort& effort) = 0;
};

/** One method of one package, with one way to set its accuracy. */
class Contestant {
 public:
  virtual ~Contestant() = default;

  virtual std::string name() const = 0;      ///< "dmv10", "odeint_dopri5_adaptive", …: [a-z0-9_] only
  virtual std::string package() const = 0;   ///< "poinsot", "Boost.odeint", …
  virtual std::string version() const = 0;   ///< as the package itself tells it
  virtual std::string settings() const = 0;  ///< how it is driven, in a sentence, for the document

  /** What is set to change its accuracy. */
  enum class Knob {
    step,       ///< [s]: takes ⌈horizon/step⌉ equal steps
    tolerance,  ///< relative and absolute tolerance alike; the solver finds its steps
    none        ///< has one accuracy
  };
  virtual Knob knob() const = 0;

  /** Never nullptr; throws std::exception where the solver refuses. */
  virtual std::unique_ptr<Run> start(const Problem& problem, double setting) const = 0;
};

using Contestants = std::vector<std::unique_ptr<Contestant>>;

// Each in the file of its name; those of packages that are not installed are not built.
void addPoinsot(Contestants& to);
void addOdeint(Contestants& to);
void addGsl(Contestants& to);
void addSundials(Contestants& to);
void addBullet(Contestants& to);
void addOde(Contestants& to);
void addDart(Contestants& to);
void addSimbody(Contestants& to);
void addMujoco(Contestants& to);

}  // namespace poinsot::work_precision
