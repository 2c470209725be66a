#define POINSOT_TAYLOR_LEVEL baseline
#include "../closed_form/levels.h"
#include "series.h"

namespace poinsot::taylor {

LeftOut stepBaseline(const Body& body, const Start& start, int order, double h, Increment& out) {
  return baseline::run(body, start, order, h, out);
}

Step bestStep() {
#ifdef POINSOT_X86_64_LEVELS
  if (&closed_form::bestLevel() != &closed_form::kBaseline) return stepV3;
#endif
  return stepBaseline;
}

}  // namespace poinsot::taylor
