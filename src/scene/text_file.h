#pragma once

#include <cstddef>
#include <string>

namespace poinsot::scene {

/** The largest size of a file that is read [bytes]. */
constexpr std::size_t kLargestTextFile = 4 * 1024 * 1024;

/**
 * Returns the bytes of a regular file of at most kLargestTextFile bytes, also while another process writes to it.
 * Throws Error at once where the path leads to something else: reading a pipe or a device might never end.
 */
std::string readTextFile(const std::string& path);

}  // namespace poinsot::scene
