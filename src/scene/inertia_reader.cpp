#include "inertia_reader.h"

#include <Eigen/Core>
#include <stdexcept>

#include "number.h"

namespace poinsot::scene {
namespace {

const char* const kExpected =
    "3 positive finite principal moments, or a symmetric positive definite tensor as 3 lists of 3 finite numbers "
    "(kg·m²)";

bool holdsLists(const Place& list) {
  for (std::size_t i = 0; i < list.node().size(); ++i) {
    if (list.node()[i].IsSequence()) return true;
  }
  return false;
}

}  // namespace

PrincipalInertia readInertia(const Place& place) {
  place.requireList(kExpected, 3, 3);
  try {
    if (!holdsLists(place)) return PrincipalInertia::fromMoments(readVector(place, quantity::kInertia));
    Eigen::Matrix3d tensor;
    for (int row = 0; row < 3; ++row) tensor.row(row) = readVector(place.item(row), quantity::kInertiaEntry);
    return PrincipalInertia::fromTensor(tensor);
  } catch (const std::invalid_argument& objection) {
    place.refuse(kExpected, "another list", objection.what());
  }
}

}  // namespace poinsot::scene
