#pragma once

namespace poinsot {

/**
 * Counts what the thread that made it allocates while it lives: malloc, calloc, realloc and the aligned kinds, and with
 * them every operator new. Link allocation_counter.cpp, which puts itself in front of the C library's functions.
 */
class AllocationCounter {
 public:
  AllocationCounter();
  ~AllocationCounter();
  AllocationCounter(const AllocationCounter&) = delete;
  AllocationCounter& operator=(const AllocationCounter&) = delete;

  long count() const;
};

}  // namespace poinsot
