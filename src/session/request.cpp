#include "poinsot/session/request.h"

namespace poinsot::session {

bool sameKind(const Request& a, const Request& b) {
  if (a.index() != b.index()) return false;
  if (const auto* method = std::get_if<SetMethod>(&a)) {
    const auto& other = std::get<SetMethod>(b);
    return method->body == other.body && method->method == other.method;
  }
  if (const auto* spin = std::get_if<SetSpin>(&a)) return spin->body == std::get<SetSpin>(b).body;
  return true;
}

}  // namespace poinsot::session
