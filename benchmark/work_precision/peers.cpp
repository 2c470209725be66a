#include "peers.h"

namespace poinsot::work_precision {

void addPeers(Contestants& to) {
  addOdeint(to);
#ifdef POINSOT_WITH_GSL
  addGsl(to);
#endif
#ifdef POINSOT_WITH_SUNDIALS
  addSundials(to);
#endif
#ifdef POINSOT_WITH_BULLET
  addBullet(to);
#endif
#ifdef POINSOT_WITH_ODE
  addOde(to);
#endif
#ifdef POINSOT_WITH_DART
  addDart(to);
#endif
#ifdef POINSOT_WITH_SIMBODY
  addSimbody(to);
#endif
#ifdef POINSOT_WITH_MUJOCO
  addMujoco(to);
#endif
}

}  // namespace poinsot::work_precision
