#include "synonyms.h"

#include "characters.h"
#include "words.h"

namespace poinsot::scene {
namespace {

// A word may stand here several times: the first meaning that is possible at its place is suggested.
const Synonym kSynonyms[] = {
    // keys of the scene
    {"body", "bodies", ""},
    {"objects", "bodies", ""},
    {"rigid_bodies", "bodies", ""},
    {"frequency", "rate", ""},
    {"hz", "rate", ""},
    {"fps", "rate", ""},
    // keys of a body
    {"frame", "name", ", which is also its frame"},
    {"id", "name", ""},
    {"frame_id", "name", ", which is also its frame"},
    {"moments", "inertia", ""},
    {"moment_of_inertia", "inertia", ""},
    {"moments_of_inertia", "inertia", ""},
    {"tensor", "inertia", ""},
    {"size", "shape", ", which takes a type with its sizes and mass"},
    {"dimensions", "shape", ", which takes a type with its sizes and mass"},
    {"mass", "shape", ", which takes a type with its sizes and mass"},
    {"geometry", "shape", ""},
    {"box", "shape", ", which takes type: box"},
    {"cylinder", "shape", ", which takes type: cylinder"},
    {"ellipsoid", "shape", ", which takes type: ellipsoid"},
    {"mesh", "appearance", ", which takes a mesh"},
    {"visual", "appearance", ", which takes a mesh"},
    {"orientation", "attitude", ""},
    {"quaternion", "attitude", ""},
    {"rotation", "attitude", ""},
    {"omega", "angular_velocity", ""},
    {"omega_body", "angular_velocity", ""},
    {"w", "angular_velocity", ""},
    {"spin", "angular_velocity", ""},
    {"angular_rate", "angular_velocity", ""},
    {"integrator", "method", ""},
    {"solver", "method", ""},
    {"stepper", "method", ""},
    {"dt", "step", ""},
    {"h", "step", ""},
    {"time_step", "step", ""},
    {"timestep", "step", ""},
    {"step_size", "step", ""},
    {"tolerance", "accuracy", ""},
    {"precision", "accuracy", ""},
    {"duration", "horizon", ""},
    {"position", "effects", ", which take type: translation with a position"},
    {"velocity", "effects", ", which take type: translation with a velocity"},
    {"acceleration", "effects", ", which take type: translation with an acceleration"},
    {"translation", "effects", ", which take type: translation"},
    {"gravity", "effects", ", which take type: gravity_torque or translation"},
    {"torque", "effects", ", which take type: constant_torque"},
    {"torques", "effects", ""},
    {"forces", "effects", ""},
    {"damping", "effects", ", which take type: viscous_damping"},
    // keys of shapes, meshes and effects
    {"kind", "type", ""},
    {"dimensions", "size", ""},
    {"lengths", "size", ""},
    {"length", "height", ""},
    {"r", "radius", ""},
    {"weight", "mass", ""},
    {"file", "mesh", ""},
    {"quaternion", "orientation", ""},
    {"attitude", "orientation", ""},
    {"rotation", "orientation", ""},
    {"g", "gravity", ""},
    {"center_of_mass", "centre_of_mass", ""},
    {"com", "centre_of_mass", ""},
    {"start", "from", ""},
    {"end", "to", ""},
    // types of shapes and effects, and methods
    {"cube", "box", ""},
    {"cuboid", "box", ""},
    {"brick", "box", ""},
    {"sphere", "ellipsoid", ""},
    {"ball", "ellipsoid", ""},
    {"rod", "cylinder", ""},
    {"disc", "cylinder", ""},
    {"disk", "cylinder", ""},
    {"gravity", "gravity_torque", ""},
    {"weight", "gravity_torque", ""},
    {"torque", "constant_torque", ""},
    {"damping", "viscous_damping", ""},
    {"drag", "viscous_damping", ""},
    {"dissipation", "internal_dissipation", ""},
    {"slug", "internal_dissipation", ""},
    {"thruster", "torque_schedule", ""},
    {"thrusters", "torque_schedule", ""},
    {"orbit", "gravity_gradient", ""},
    {"exact", "closed_form", ""},
    {"analytic", "closed_form", ""},
    {"euler", "lie_euler", ""},
    {"runge_kutta", "rk4", ""},
};

}  // namespace

const Synonym* synonymOf(const std::string& word, const std::vector<std::string>& candidates) {
  const std::string small = lower(word);
  for (const Synonym& synonym : kSynonyms) {
    if (small == synonym.word && contains(candidates, synonym.meant)) return &synonym;
  }
  return nullptr;
}

}  // namespace poinsot::scene
