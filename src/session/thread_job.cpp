#include "poinsot/session/thread_job.h"

#include <utility>

namespace poinsot::session {

void ThreadJob::start(Work work) {
  cancelled_ = false;
  outcome_ = std::async(std::launch::async, [this, work = std::move(work)] { return work(cancelled_); });
}

std::optional<Outcome> ThreadJob::poll() {
  if (!outcome_.valid() || !endsWithin(std::chrono::milliseconds(0))) return std::nullopt;
  return outcome_.get();
}

bool ThreadJob::endsWithin(std::chrono::milliseconds patience) const {
  return !outcome_.valid() || outcome_.wait_for(patience) == std::future_status::ready;
}

}  // namespace poinsot::session
