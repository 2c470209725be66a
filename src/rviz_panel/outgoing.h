#pragma once

#include <QElapsedTimer>
#include <functional>

namespace poinsot::rviz_panel {

/** Keeps the last of what is to be published until somebody listens, for a few seconds, and paces it. */
class Outgoing {
 public:
  using Send = std::function<bool()>;  ///< returns false while nobody listens

  /** Sends it in place of what waits, now or, if the last was sent a moment ago, with a later flush(). */
  void set(Send send);
  /** Sends what waits. */
  void flush();
  /** Forgets what waits. */
  void drop() { send_ = nullptr; }

 private:
  Send send_;  ///< empty: nothing to send
  QElapsedTimer since_set_;
  QElapsedTimer since_sent_;
};

}  // namespace poinsot::rviz_panel
