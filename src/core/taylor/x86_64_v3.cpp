// Compiled for AVX2 and FMA; empty where the compiler is not told so, on other processors.
#ifdef __AVX2__
#define POINSOT_TAYLOR_LEVEL x86_64_v3
#include "series.h"

namespace poinsot::taylor {

LeftOut stepV3(const Body& body, const Start& start, int order, double h, Increment& out) {
  return x86_64_v3::run(body, start, order, h, out);
}

}  // namespace poinsot::taylor
#endif
