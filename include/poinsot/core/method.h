#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "poinsot/core/stepper.h"
#include "poinsot/core/torques.h"

namespace poinsot {

/** One row of the table of methods. */
struct Method {
  const char* name;         ///< in scenes and programs
  int order;                ///< the global error of a motion falls with h to this power
  bool conserves_momentum;  ///< whether it keeps L of a free body (world axes), to roundoff
  bool conserves_energy;    ///< whether it keeps E of a free body, to roundoff
  bool takes_damping;       ///< whether it takes torques that depend on Ω, not only those that depend on t and R
  bool cuts_steps;          ///< whether it divides a step that is too long for it

  /** Binds it to a free body; nullptr where it moves no free bodies.
   * @param moments principal moments [kg·m²], valid. */
  std::unique_ptr<Stepper> (*make_free)(const Eigen::Vector3d& moments);
  /** Binds it to a body under torques; nullptr where it takes no torques. */
  std::unique_ptr<Stepper> (*make_torqued)(const Torques& torques);

  /**
   * Binds it to a free body. Throws std::invalid_argument where it moves no free bodies.
   * @param moments principal moments [kg·m²], valid.
   */
  std::unique_ptr<Stepper> make(const Eigen::Vector3d& moments) const;
  /** Binds it to a body under torques to which it has no objection. Throws std::invalid_argument where it takes none.
   */
  std::unique_ptr<Stepper> make(const Torques& torques) const;
};

/** Returns all methods that this version has. */
const std::vector<Method>& methods();
/** Returns the methods for free bodies, in the order in which they are listed to users: lie_euler, buss2, … */
const std::vector<Method>& freeMethods();
/** Returns the methods for bodies under torques, likewise: taylor8, … */
const std::vector<Method>& torquedMethods();

/** Returns the method of that name in the list, or nullptr. */
const Method* findMethod(const std::string& name, const std::vector<Method>& list = methods());

/** Returns "lie_euler, buss2, …" for messages. */
std::string methodNames(const std::vector<Method>& list);

/** Returns why the method does not take these torques; empty when it does. */
std::string objectionTo(const Method& method, const Torques& torques);

}  // namespace poinsot
