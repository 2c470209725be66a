#pragma once

#include <algorithm>
#include <string>
#include <vector>

/** What was asked for, in words, several requests at once. */
namespace poinsot::node {

/** The requests of `first` and then those of `then` that are not among them. */
inline std::vector<std::string> withAll(std::vector<std::string> first, const std::vector<std::string>& then) {
  for (const std::string& request : then) {
    if (std::find(first.begin(), first.end(), request) == first.end()) first.push_back(request);
  }
  return first;
}

/** "spin of a and method rk4 of b". */
inline std::string joined(const std::vector<std::string>& requests) {
  std::string out;
  for (const std::string& request : requests) out += (out.empty() ? "" : " and ") + request;
  return out;
}

}  // namespace poinsot::node
