#include "outgoing.h"

#include <utility>

namespace poinsot::rviz_panel {
namespace {

constexpr int kPause = 50;                  // ms between two messages
constexpr int kPatienceForListener = 3000;  // ms, after which what nobody listened to is dropped

}  // namespace

void Outgoing::set(Send send) {
  send_ = std::move(send);
  since_set_.start();
  if (!since_sent_.isValid() || since_sent_.hasExpired(kPause)) flush();
}

void Outgoing::flush() {
  if (!send_) return;
  if (send_()) {
    send_ = nullptr;
    since_sent_.start();
  } else if (since_set_.hasExpired(kPatienceForListener)) {
    send_ = nullptr;
  }
}

}  // namespace poinsot::rviz_panel
