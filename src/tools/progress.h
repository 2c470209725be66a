#pragma once

#include <cstdint>
#include <memory>

namespace poinsot::tools {

/** A progress bar on stderr; none where that is not a terminal. */
class Progress {
 public:
  explicit Progress(std::int64_t total);
  ~Progress();

  void add(std::int64_t done);

 private:
  struct Bar;
  std::unique_ptr<Bar> bar_;
};

}  // namespace poinsot::tools
