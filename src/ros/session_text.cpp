#include "poinsot/ros/session_text.h"

#include <algorithm>

#include "poinsot/core/number_text.h"
#include "poinsot/ros/scene_list.h"

namespace poinsot::node {
namespace {

using session::Reason;
using session::Request;

std::string textOf(const Request& request) {
  if (const auto* load = std::get_if<session::LoadScene>(&request)) return "scene " + sceneName(load->scene);
  if (const auto* method = std::get_if<session::SetMethod>(&request)) {
    return "method " + method->method + " of " + method->body;
  }
  if (const auto* spin = std::get_if<session::SetSpin>(&request)) return "spin of " + spin->body;
  if (std::holds_alternative<session::Reset>(request)) return "reset";
  if (std::holds_alternative<session::Seek>(request)) return "seek";
  if (std::holds_alternative<session::SetSpeed>(request)) return "speed";
  return std::holds_alternative<session::Step>(request) ? "step" : "pause";
}

}  // namespace

std::string textOf(const std::vector<Request>& requests) {
  std::vector<std::string> words;
  for (const Request& request : requests) {
    const std::string text = textOf(request);
    if (std::find(words.begin(), words.end(), text) == words.end()) words.push_back(text);
  }
  std::string out;
  for (const std::string& text : words) out += (out.empty() ? "" : " and ") + text;
  return out;
}

std::string textOf(const session::Refusal& refusal) {
  const auto* speed = std::get_if<session::SetSpeed>(&refusal.requests.front());
  const auto* seek = std::get_if<session::Seek>(&refusal.requests.front());
  switch (refusal.reason) {
    case Reason::not_finite:
      if (speed) return "speed refused: expected a finite number, got " + numberText(speed->speed);
      return "seek refused: expected a finite time (s), got " + numberText(seek->time);
    case Reason::too_fast:
      if (speed) {
        return "speed refused: expected a number from -" + numberText(refusal.limit) + " to " +
               numberText(refusal.limit) + ", got " + numberText(speed->speed) + ": the steps of this scene cost " +
               numberText(refusal.figure) + " CPU s per simulated s here";
      }
      return textOf(refusal.requests) + " refused: expected steps that cost at most " + numberText(refusal.limit) +
             " CPU s per simulated s at speed " + numberText(refusal.speed) + ", got " + numberText(refusal.figure) +
             " here; take larger steps or a lower speed";
    case Reason::too_many_steps:
      return "seek to " + numberText(seek->time) + " s refused: expected at most " + numberText(refusal.limit) +
             " steps, got " + numberText(refusal.figure) + " of " + numberText(refusal.step) + " s for body " +
             refusal.body + " under " + refusal.method;
    case Reason::no_state:
      return "seek to " + numberText(seek->time) + " s refused: expected a time at which every body has a state; " +
             (refusal.body.empty() ? "" : "body " + refusal.body + ": ") + refusal.detail;
    case Reason::not_paused:
      return "step refused: expected a paused node, got one that plays; call ~pause with data: true first";
    case Reason::cannot_be_made:
      return textOf(refusal.requests) + " refused: " + refusal.detail;
    case Reason::bad_request:
      break;
  }
  return refusal.detail;
}

std::string regimeText(const session::BodyStatus& body) {
  if (!body.free) return "under torque";
  if (body.free->beside_separatrix) return "on the separatrix, to rounding";
  return view::textOf(body.free->regime, body.free->moments, body.free->omega_principal);
}

}  // namespace poinsot::node
