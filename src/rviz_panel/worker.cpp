#include "worker.h"

#include <QRunnable>
#include <utility>

namespace poinsot::rviz_panel {
namespace {

constexpr int kPatienceForJobs = 1000;  // ms

class Job : public QRunnable {
 public:
  explicit Job(std::function<void()> job) : job_(std::move(job)) {}
  void run() override { job_(); }

 private:
  std::function<void()> job_;
};

}  // namespace

void Mailbox::post(std::function<void()> letter) {
  const std::lock_guard<std::mutex> lock(mutex_);
  letters_.push_back(std::move(letter));
}

void Mailbox::read() {
  std::deque<std::function<void()>> letters;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    letters.swap(letters_);
  }
  for (const auto& letter : letters) letter();
}

Worker::~Worker() {
  if (pool_->waitForDone(kPatienceForJobs)) delete pool_;  // its destructor would wait for a job that hangs
}

void Worker::post(std::function<void()> job) {
  pool_->start(new Job(std::move(job)));
}

}  // namespace poinsot::rviz_panel
