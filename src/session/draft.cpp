#include "poinsot/session/draft.h"

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <cmath>
#include <utility>

#include "limits.h"
#include "poinsot/core/number_text.h"
#include "poinsot/scene/changes.h"
#include "poinsot/scene/reader.h"

namespace poinsot::session {
namespace {

/** Adds the request to those of the draft, in place of an earlier one of the same kind. */
void note(const Request& request, Draft& draft) {
  const auto known = std::find_if(draft.requests.begin(), draft.requests.end(),
                                  [&](const Request& other) { return sameKind(request, other); });
  if (known == draft.requests.end()) {
    draft.requests.push_back(request);
  } else {
    *known = request;
  }
}

/** Returns whether both bodies start with the same place, velocity, attitude and Ω. */
bool sameStart(const scene::Body& a, const scene::Body& b) {
  const bool same_place = a.translation.has_value() == b.translation.has_value() &&
                          (!a.translation || (a.translation->position == b.translation->position &&
                                              a.translation->velocity == b.translation->velocity));
  return same_place && a.omega_body == b.omega_body && a.attitude.coeffs() == b.attitude.coeffs();
}

Answer load(const LoadScene& request, Draft& draft, const ReadScene& read) {
  Draft out;
  static_cast<NamedScene&>(out) = read(request.scene);
  out.start_scene = out.scene;
  Answer answer;
  answer.warnings = out.scene.warnings;
  answer.scene = out.name;
  out.all = out.from_start = true;
  out.requests = {request};
  draft = std::move(out);
  return answer;
}

Answer changeMethod(const SetMethod& request, double coming_time, Draft& draft) {
  const std::size_t i = indexOf(draft.scene, request.body);
  Answer answer;
  scene::Body body = scene::withMethod(draft.scene.bodies[i], request.method, request.step, answer.warnings);
  if (body.step) {
    const double time = draft.from_start ? 0 : coming_time, steps = std::abs(time) / *body.step;
    if (!(steps <= kMostSteps)) throw scene::Error(tooManySteps(request.body, time, steps, *body.step));
  }
  answer.method = body.method;
  answer.step = body.step;
  // What a reset brings back is the start; the method stays.
  draft.scene.bodies[i] = std::move(body);
  draft.bodies.insert(i);
  note(request, draft);
  return answer;
}

Answer changeSpin(const SetSpin& request, const MotionState& state, Draft& draft) {
  const std::size_t i = indexOf(draft.scene, request.body);
  draft.scene.bodies[i] = scene::withSpin(draft.scene.bodies[i], state, request.omega_body);
  draft.bodies.insert(i);
  draft.from_start = true;
  draft.seek.reset();
  note(request, draft);
  return {};
}

Answer reset(Draft& draft) {
  Answer answer;
  answer.in_the_background = true;
  for (std::size_t i = 0; i < draft.scene.bodies.size(); ++i) {
    if (sameStart(draft.scene.bodies[i], draft.start_scene.bodies[i])) continue;
    draft.scene.bodies[i] = scene::withStartOf(draft.scene.bodies[i], draft.start_scene.bodies[i]);
    draft.bodies.insert(i);
    answer.spins = true;
  }
  draft.from_start = draft.reset = true;
  draft.seek.reset();
  if (answer.spins) {
    draft.redraw = true;
    draft.requests.clear();
  }
  note(Reset{}, draft);
  return answer;
}

}  // namespace

std::size_t indexOf(const scene::Scene& scene, const std::string& body) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].name == body) return i;
    names.push_back(scene.bodies[i].name);
  }
  throw scene::Error("body: expected one of " + boost::algorithm::join(names, ", ") + ", got \"" + body + "\"");
}

bool startsDiffer(const scene::Scene& scene, const scene::Scene& start_scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (!sameStart(scene.bodies[i], start_scene.bodies[i])) return true;
  }
  return false;
}

Answer apply(const Asked& asked, Draft& draft, const ReadScene& read) {
  if (const auto* request = std::get_if<LoadScene>(&asked.request)) return load(*request, draft, read);
  if (const auto* request = std::get_if<SetMethod>(&asked.request)) {
    return changeMethod(*request, asked.coming_time, draft);
  }
  if (const auto* request = std::get_if<SetSpin>(&asked.request)) return changeSpin(*request, asked.state, draft);
  if (const auto* request = std::get_if<Seek>(&asked.request)) {
    draft.seek = request->time;
    return {};
  }
  return reset(draft);
}

std::string tooManySteps(const std::string& body, double time, double steps, double step) {
  return "body \"" + body + "\": expected at most " + numberText(kMostSteps) + " steps, got " + numberText(steps) +
         " steps of " + numberText(step) + " s to t = " + numberText(time) + " s; seek nearer to t = 0 first";
}

}  // namespace poinsot::session
