#include "levels.h"

#include <cstdlib>
#include <cstring>

namespace poinsot::closed_form {
namespace {

const Level& detect() {
#ifdef POINSOT_X86_64_LEVELS
  const char* limit = std::getenv("POINSOT_SIMD");
  if (limit && std::strcmp(limit, kBaseline.name) == 0) return kBaseline;
  const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                  __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
  if (v4 && !(limit && std::strcmp(limit, kV3.name) == 0)) return kV4;
  if (v3) return kV3;
#endif
  return kBaseline;
}

}  // namespace

const Level& bestLevel() {
  static const Level& level = detect();
  return level;
}

}  // namespace poinsot::closed_form
