#pragma once

#include <string>
#include <vector>

/** The pieces of a message about what was given, the same for all who refuse something. */
namespace poinsot::scene {

/** "expected X, got Y", and after a colon the reason, where there is one. */
std::string expectedGot(const std::string& expected, const std::string& got, const std::string& why = "");

/** "a, b, c". */
std::string joined(const std::vector<std::string>& words);

/**
 * ` (did you mean "step"?)` where one of the candidates is another word for this one (`dt`), or at most two edits away;
 * otherwise empty.
 */
std::string didYouMean(const std::string& word, const std::vector<std::string>& candidates);

}  // namespace poinsot::scene
