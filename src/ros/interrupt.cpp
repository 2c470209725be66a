#include "poinsot/ros/interrupt.h"

#include <csignal>

namespace poinsot::node {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // else a signal handler could not set it

void onSignal(int) {
  interrupted = true;
}

}  // namespace

const std::atomic<bool>& interruptFlag() {
  struct sigaction action = {};
  action.sa_handler = onSignal;
  action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  return interrupted;
}

}  // namespace poinsot::node
