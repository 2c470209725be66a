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
  const char* name;         ///< by which scenes and programs ask for it
  int order;                ///< the global error of a motion falls with h to this power
  bool conserves_momentum;  ///< of a free body L in world axes, to roundoff
  bool conserves_energy;    ///< of a free body E, to roundoff
  bool takes_damping;       ///< moves bodies also under torques that depend on Ω, not only on t and R
  bool cuts_steps;          ///< takes a step that is too long for it in parts

  /** Binds it to a free body; nullptr for a method that moves none. @param moments principal moments [kg·m²], valid. */
  std::unique_ptr<Stepper> (*make_free)(const Eigen::Vector3d& moments);
  /** Binds it to a body under torques; nullptr for a method that takes none. */
  std::unique_ptr<Stepper> (*make_torqued)(const Torques& torques);

  /** Binds a method that moves free bodies to one. @param moments principal moments [kg·m²], valid. */
  std::unique_ptr<Stepper> make(const Eigen::Vector3d& moments) const { return make_free(moments); }
  /** Binds a method to a body under torques to which it has no objection. */
  std::unique_ptr<Stepper> make(const Torques& torques) const { return make_torqued(torques); }
};

/** All methods that this version has. */
const std::vector<Method>& methods();
/** Those that move free bodies, in the order in which they are listed to users: lie_euler, buss2, … */
const std::vector<Method>& freeMethods();
/** Those that move bodies under torques, likewise: taylor8, … */
const std::vector<Method>& torquedMethods();

/** The method of that name in the list, or nullptr. */
const Method* findMethod(const std::string& name, const std::vector<Method>& list = methods());

/** "lie_euler, buss2, …" for messages. */
std::string methodNames(const std::vector<Method>& list);

/** Why the method does not take these torques; empty when it does. */
std::string objectionTo(const Method& method, const Torques& torques);

}  // namespace poinsot
