#include "worker.h"

#include <QRunnable>
#include <utility>

namespace poinsot::rviz_panel {
namespace {

constexpr int kPatience = 1000;  // ms

class Task : public QRunnable {
 public:
  explicit Task(std::function<void()> act) : act_(std::move(act)) {}
  void run() override { act_(); }

 private:
  std::function<void()> act_;
};

}  // namespace

Worker::~Worker() {
  if (pool_->waitForDone(kPatience)) delete pool_;  // its destructor would wait for a job that hangs
}

void Worker::post(Job job) {
  pool_->start(new Task([job = std::move(job), mailbox = mailbox_] {
    Answer answer = job();
    const std::lock_guard<std::mutex> lock(mailbox->mutex);
    if (answer) mailbox->answers.push_back(std::move(answer));
  }));
}

void Worker::read() {
  std::deque<Answer> answers;
  {
    const std::lock_guard<std::mutex> lock(mailbox_->mutex);
    answers.swap(mailbox_->answers);
  }
  for (const Answer& answer : answers) answer();
}

void Worker::drop() {
  pool_->clear();
  mailbox_ = std::make_shared<Mailbox>();
}

}  // namespace poinsot::rviz_panel
