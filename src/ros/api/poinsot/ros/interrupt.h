#pragma once

#include <atomic>

namespace poinsot::node {

/**
 * From the first call on, SIGINT and SIGTERM set the flag that is returned, and no more: ROS stays up until whoever
 * uses it has come to an end. The second signal of a kind ends the program at once.
 */
const std::atomic<bool>& interruptFlag();

}  // namespace poinsot::node
