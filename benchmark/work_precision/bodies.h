#pragma once

#include <vector>

#include "contestant.h"

namespace poinsot::work_precision {

/** The free bodies of the benchmark. make_truth.py reads them from `work_precision_measure --bodies`. */
const std::vector<Problem>& bodies();

/** A state known to 25 digits, as the doubles nearest to it. */
struct Truth {
  const char* body;
  Answer answer;
};

/** The truths for every body at some times up to 1000 s; made by make_truth.py. */
const std::vector<Truth>& truths();

}  // namespace poinsot::work_precision
