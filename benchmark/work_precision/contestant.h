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

/** The answer of a contestant for one time, unchanged: the attitude is normalised only if the solver does so itself. */
struct Answer {
  double time = 0;       ///< [s]
  double time_rest = 0;  ///< the intended time minus `time`, which is rounded [s]
  Eigen::Quaterniond attitude = Eigen::Quaterniond::Identity();
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();  ///< body axes

  Answer() = default;
  Answer(double at, const Eigen::Quaterniond& q, const Eigen::Vector3d& o) : time(at), attitude(q), omega(o) {}
};

/** The work of a run. */
struct Effort {
  static constexpr std::int64_t kUnknown = -1;
  std::int64_t steps = 0;               ///< of the solver, those it rejected included
  std::int64_t evaluations = kUnknown;  ///< of the right-hand side, or of the equation that an implicit method solves
  std::int64_t exponentials = 0;        ///< of SO(3)
};

/** Called with the state of the solver after one of its steps, at least 200 times in a run of more steps. */
using Watch = std::function<void(const Answer&)>;

/** A solver prepared for one problem at one setting. Everything that a user would do once for a body is done; what
 * depends on the start or the horizon is part of a run. */
class Run {
 public:
  virtual ~Run() = default;

  /**
   * From the start to `horizon` > 0 by the solver's own steps; returns the state at exactly `horizon`.
   * @param watch called after steps, if it is set. Timed runs have none, so it costs nothing in the loop.
   */
  virtual Answer shot(double horizon, const Watch& watch, Effort& effort) = 0;

  /**
   * Writes the states at t = interval, 2·interval, … count·interval into `out`, which has room for them, by the best
   * means of the solver: dense output if it has one, otherwise steps that end at these times.
   */
  virtual void ticks(double interval, std::int64_t count, Answer* out, Effort& effort) = 0;
};

/** One method of one package, with one setting for its accuracy. */
class Contestant {
 public:
  virtual ~Contestant() = default;

  virtual std::string name() const = 0;      ///< "dmv10", "odeint_dopri5_adaptive", …: [a-z0-9_] only
  virtual std::string package() const = 0;   ///< "poinsot", "Boost.odeint", …
  virtual std::string version() const = 0;   ///< as the package reports it
  virtual std::string settings() const = 0;  ///< how it is driven, in a sentence, for the document

  /** The setting that changes its accuracy. */
  enum class Knob {
    step,       ///< [s]: takes ⌈horizon/step⌉ equal steps
    tolerance,  ///< relative and absolute tolerance alike; the solver finds its steps
    none        ///< its accuracy is fixed
  };
  virtual Knob knob() const = 0;

  /** Never nullptr; throws std::exception where the solver refuses. */
  virtual std::unique_ptr<Run> start(const Problem& problem, double setting) const = 0;
};

using Contestants = std::vector<std::unique_ptr<Contestant>>;

// Each is in the file of its name. Those of packages that are not installed are not built.
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
