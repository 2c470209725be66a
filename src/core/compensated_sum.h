#pragma once

namespace poinsot {

/**
 * sum + rest ← sum + rest + term, without losing what falls below the last bit of `sum` (Kahan 1965, with Knuth's
 * branch-free two-sum). Works component by component on doubles and on Eigen vectors. Needs IEEE arithmetic in the
 * order written: no -ffast-math.
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
