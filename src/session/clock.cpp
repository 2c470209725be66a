#include "poinsot/session/clock.h"

#include <cmath>

namespace poinsot::session {

void Clock::pause(bool paused) {
  paused_ = paused;
  steps_left_ = 0;
}

void Clock::jumpTo(double t) {
  jump_ = t;
  steps_left_ = 0;
}

double Clock::timeAt(Nanoseconds now) const {
  if (!started_ || now <= stamp_) return time_;
  if (step_end_ && *step_end_ <= now) return anchor_time_ + step_length_;
  return anchor_time_ + rate_ * toSeconds(now - anchor_stamp_);
}

void Clock::restartStamps() {
  started_ = false;
  new_segment_ = true;
}

void Clock::anchorHere() {
  anchor_stamp_ = stamp_;
  anchor_time_ = time_;
}

std::optional<Tick> Clock::tick(Nanoseconds now) {
  if (!started_) {
    started_ = true;
    stamp_ = now;
    step_end_.reset();
    anchorHere();
  } else {
    if (now <= stamp_) return std::nullopt;
    const bool step_done = step_end_ && *step_end_ <= now;
    time_ = timeAt(now);
    stamp_ = step_done ? *step_end_ : now;
    if (step_done) {
      step_end_.reset();
      if (steps_left_ > 0) --steps_left_;
      anchorHere();
    }
  }

  if (jump_) {
    time_ = *jump_;
    jump_.reset();
    step_end_.reset();
    new_segment_ = true;
    anchorHere();
  }
  if (new_segment_) ++segment_;
  new_segment_ = false;

  const bool stepping = paused_ && steps_left_ > 0;
  const double rate = stepping ? 1.0 : paused_ ? 0.0 : speed_;
  if (rate != rate_) {
    rate_ = rate;
    anchorHere();
  }
  if (!stepping) {
    step_end_.reset();
  } else if (!step_end_) {
    anchorHere();
    step_end_ = stamp_ + std::llround(step_length_ * static_cast<double>(kSecond));
  }
  return Tick{stamp_, time_, rate_, segment_};
}

}  // namespace poinsot::session
