#pragma once

namespace poinsot {

/**
 * Adds a term to sum + rest, where `rest` holds what falls below the last bit of `sum` (Kahan 1965, with Knuth's
 * branch-free two-sum). T is double or an Eigen vector. Needs IEEE arithmetic in the order written: no -ffast-math.
 */
template <class T>
inline void addCompensated(T& sum, T& rest, const T& term) {
  const T increment = term + rest;
  const T total = sum + increment;
  const T taken = total - sum;
  rest = (sum - (total - taken)) + (increment - taken);
  sum = total;
}

}  // namespace poinsot
