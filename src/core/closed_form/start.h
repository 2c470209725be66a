#pragma once

namespace poinsot::closed_form {

/** The start of a closed form, in principal axes: moments positive and finite, attitude w, x, y, z not zero. */
struct Start {
  double moments[3], omega[3], attitude[4];
};

}  // namespace poinsot::closed_form
