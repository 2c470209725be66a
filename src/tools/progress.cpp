#include "progress.h"

#include <unistd.h>

#include <iostream>

#if __has_include(<boost/timer/progress_display.hpp>)
#include <boost/timer/progress_display.hpp>
using boost::timer::progress_display;
#else  // Boost before 1.72
#include <boost/progress.hpp>
using boost::progress_display;
#endif

namespace poinsot::tools {

struct Progress::Bar {
  explicit Bar(std::int64_t total) : display(static_cast<unsigned long>(total), std::cerr) {}
  progress_display display;
};

Progress::Progress(std::int64_t total) {
  if (isatty(STDERR_FILENO)) bar_ = std::make_unique<Bar>(total);
}

Progress::~Progress() = default;

void Progress::add(std::int64_t done) {
  if (bar_) bar_->display += static_cast<unsigned long>(done);
}

}  // namespace poinsot::tools
