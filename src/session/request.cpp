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

Refusal refusalOf(Reason reason, const std::vector<Request>& requests, const std::string& detail) {
  Refusal out;
  out.reason = reason;
  out.requests = requests;
  out.detail = detail;
  return out;
}

Answer refusedFor(const std::string& problem) {
  Answer out;
  out.refusal = refusalOf(Reason::bad_request, {}, problem);
  return out;
}

}  // namespace poinsot::session
