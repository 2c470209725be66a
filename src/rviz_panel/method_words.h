#pragma once

#include <QString>
#include <vector>

namespace poinsot::rviz_panel {

/**
 * What the panel says of a method. The panel links nothing of core, so this repeats its table of methods; a test
 * compares the two.
 */
struct MethodWords {
  const char* name;
  const char* what;
  int order;            ///< 0: exact
  bool moves_free;      ///< whether it moves free bodies
  bool keeps_momentum;  ///< whether it keeps L of a free body, to roundoff
  bool keeps_energy;    ///< whether it keeps E of a free body, to roundoff
};

const std::vector<MethodWords>& methodWords();

/** Returns what is said beside a method's name: "course notes' Algorithm 1, order 1, keeps L"; "" for one not known. */
QString wordsOfMethod(const QString& name);

}  // namespace poinsot::rviz_panel
