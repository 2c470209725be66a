#include "poinsot/core/number_text.h"

#include <locale>
#include <sstream>

namespace poinsot {

std::string numberText(double value, int digits) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(digits);
  out << value;
  return out.str();
}

}  // namespace poinsot
