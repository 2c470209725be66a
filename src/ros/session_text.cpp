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
      if (speed) return "speed " + numberText(speed->speed) + " refused: a finite number is allowed";
      return "seek to " + numberText(seek->time) + " refused: a finite time is allowed";
    case Reason::too_fast:
      if (speed) {
        return "speed " + numberText(speed->speed) + " refused: the steps of this scene cost " +
               numberText(refusal.figure) + " CPU s per simulated s; up to " + numberText(refusal.limit) +
               " is allowed here";
      }
      return textOf(refusal.requests) + " refused: its steps cost " + numberText(refusal.figure) +
             " CPU s per simulated s here, and at speed " + numberText(refusal.speed) + " at most " +
             numberText(refusal.limit) + " is allowed: take larger steps or a lower speed";
    case Reason::too_many_steps:
      return "seek to " + numberText(seek->time) + " s refused: body " + refusal.body + " under " + refusal.method +
             " would take " + numberText(refusal.figure) + " steps of " + numberText(refusal.step) + " s; at most " +
             numberText(refusal.limit) + " are allowed";
    case Reason::no_state:
      return "seek to " + numberText(seek->time) +
             " s refused: " + (refusal.body.empty() ? "" : "body " + refusal.body + ": ") + refusal.detail + " there";
    case Reason::not_paused:
      return "not paused: call ~pause with data: true first";
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
