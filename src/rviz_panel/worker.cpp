#include "worker.h"

#include <chrono>
#include <thread>
#include <utility>

namespace poinsot::rviz_panel {

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

Worker::Worker() : shared_(std::make_shared<Shared>()) {
  std::thread(&Worker::work, shared_).detach();
}

Worker::~Worker() {
  std::unique_lock<std::mutex> lock(shared_->mutex);
  shared_->stop = true;
  shared_->changed.notify_all();
  shared_->changed.wait_for(lock, std::chrono::seconds(1), [this] { return shared_->ended; });
}

void Worker::post(std::function<void()> job) {
  const std::lock_guard<std::mutex> lock(shared_->mutex);
  shared_->jobs.push_back(std::move(job));
  shared_->changed.notify_all();
}

void Worker::drop() {
  const std::lock_guard<std::mutex> lock(shared_->mutex);
  shared_->jobs.clear();
}

void Worker::work(const std::shared_ptr<Shared>& shared) {
  std::unique_lock<std::mutex> lock(shared->mutex);
  for (;;) {
    shared->changed.wait(lock, [&] { return shared->stop || !shared->jobs.empty(); });
    if (shared->jobs.empty()) break;
    {
      const std::function<void()> job = std::move(shared->jobs.front());
      shared->jobs.pop_front();
      lock.unlock();
      job();
    }  // what the job owned goes before the lock is taken again
    lock.lock();
  }
  shared->ended = true;
  shared->changed.notify_all();
}

}  // namespace poinsot::rviz_panel
