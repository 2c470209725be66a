#include "service_calls.h"

#include <utility>

namespace poinsot::rviz_panel {
namespace {

constexpr int kLongCall = 1000;  // ms
constexpr int kMostCalls = 20;   // waiting to be answered

}  // namespace

void ServiceCalls::add(const std::string& name, Call call) {
  if (waiting_ >= kMostCalls) {
    told_(false, "The node has not answered yet; wait a moment.");
    return;
  }
  if (waiting_++ == 0) since_.start();
  worker_.post([this, mailbox = mailbox_, name, call = std::move(call), generation = generation_] {
    bool done = false;
    std::string message = "No answer from " + name + ".";
    call(done, message);
    mailbox->post([this, done, message, generation] {
      if (generation != generation_) return;
      --waiting_;
      since_.start();
      told_(done, QString::fromStdString(message));
    });
  });
}

void ServiceCalls::forget() {
  worker_.drop();
  waiting_ = 0;
  ++generation_;
}

bool ServiceCalls::waiting() const {
  return waiting_ > 0 && since_.hasExpired(kLongCall);
}

}  // namespace poinsot::rviz_panel
