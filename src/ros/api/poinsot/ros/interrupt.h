#pragma once

#include <atomic>

namespace poinsot::node {

/**
 * Returns a flag that SIGINT and SIGTERM set from the first call on. They do nothing else: ROS stays up until those
 * that use it have ended. The second signal of a kind ends the program at once.
 */
const std::atomic<bool>& interruptFlag();

}  // namespace poinsot::node
