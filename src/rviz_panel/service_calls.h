#pragma once

#include <ros/service.h>

#include <QElapsedTimer>
#include <QString>
#include <functional>
#include <memory>
#include <string>

#include "worker.h"

namespace poinsot::rviz_panel {

/** Calls services one after another on a thread of their own, so that nobody waits for the answers. */
class ServiceCalls {
 public:
  /** What became of a call: whether it was done, and the message of the service, or that it did not answer. */
  using Told = std::function<void(bool done, const QString& message)>;

  explicit ServiceCalls(Told told) : told_(std::move(told)) {}

  template <typename Service>
  void add(const std::string& name, typename Service::Request request) {
    add(name, [name, request](bool& done, std::string& message) mutable {
      typename Service::Response answer;
      if (!ros::service::call(name, request, answer)) return;
      done = answer.success;
      message = answer.message;
    });
  }
  /** Drops the calls that have not begun, and ignores the answer to the one that has. */
  void forget();
  /** Tells what has been answered so far. */
  void read() { mailbox_->read(); }
  /** Has there been no answer for more than a moment? */
  bool waiting() const;

 private:
  using Call = std::function<void(bool& done, std::string& message)>;
  void add(const std::string& name, Call call);

  Told told_;
  int waiting_ = 0;
  int generation_ = 0;  ///< of the answers that still matter
  QElapsedTimer since_;
  std::shared_ptr<Mailbox> mailbox_ = std::make_shared<Mailbox>();
  Worker worker_;
};

}  // namespace poinsot::rviz_panel
