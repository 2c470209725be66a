// From requests that change bodies to the bodies that play.
#include <algorithm>
#include <exception>
#include <memory>
#include <utility>

#include "limits.h"
#include "poinsot/cost/cancelled.h"
#include "poinsot/scene/changes.h"
#include "poinsot/scene/reader.h"
#include "poinsot/session/session.h"

namespace poinsot::session {
namespace {

/** Returns whether the request needs neither a file nor trials of a step, so that it is done between two ticks. */
bool isQuick(const Request& request) {
  return !std::holds_alternative<LoadScene>(request) && !std::holds_alternative<SetMethod>(request);
}

/** Throws scene::Error for a method that cannot move the body, before work that is under way is given up for it. */
void requireMethod(const scene::Scene& scene, const SetMethod& request) {
  const scene::Body& body = scene.bodies[indexOf(scene, request.body)];
  const std::vector<std::string> names = scene::methodsFor(body);
  if (std::find(names.begin(), names.end(), request.method) != names.end()) return;
  std::vector<std::string> warnings;
  scene::withMethod(body, request.method, request.step, warnings);  // throws, with the methods that there are
}

/** Returns the answers to requests where preparing itself has failed. */
Prepared nothingPrepared(std::size_t asked, const std::string& problem) {
  Prepared out;
  out.answers.assign(asked, refusedFor(problem));
  return out;
}

}  // namespace

bool Session::loading() const {
  return (draft_ && draft_->all) || std::any_of(queue_.begin(), queue_.end(), [](const Waiting& one) {
           return std::holds_alternative<LoadScene>(one.asked.request);
         });
}

Draft Session::present() const {
  Draft out;
  static_cast<NamedScene&>(out) = playing_;
  out.start_scene = start_scene_;
  return out;
}

void Session::enqueue(const Request& request, const Reply& reply) {
  Waiting one;
  one.asked.request = request;
  one.asked.coming_time = clock_.comingTime();
  one.reply = reply;
  try {
    if (auto* load = std::get_if<LoadScene>(&one.asked.request)) {
      if (load->scene.empty()) load->scene = playing_.file;
      if (load->scene.empty())
        throw scene::Error("scene: expected a name or a path, got none: the present scene has no file");
      load->scene = options_.find(load->scene);
    } else if (loading()) {
      throw scene::Error("a change of a body refused: another scene is being made ready; ask again when it plays");
    } else if (const auto* method = std::get_if<SetMethod>(&request)) {
      requireMethod(playing_.scene, *method);
    } else if (const auto* spin = std::get_if<SetSpin>(&request)) {
      one.asked.state = bodies_[indexOf(playing_.scene, spin->body)]->state();
    }
  } catch (const std::exception& error) {
    const Answer answer = refuse(request, error.what());
    if (reply) reply(answer);
    return;
  }
  queue_.push_back(std::move(one));
  startNext();
}

std::vector<Asked> Session::allAsked() const {
  std::vector<Asked> out;
  for (const Waiting& one : queue_) out.push_back(one.asked);
  return out;
}

void Session::serve(Nanoseconds now) {
  takeOutcome();
  startNext();
  if (!drag_.isForgotten(now)) return;
  listener_.handIsGone(drag_.body());
  endDrag();
}

void Session::startNext() {
  if (!queue_.empty() && work_.kind != Work::Kind::preparing) {
    if (std::all_of(queue_.begin(), queue_.end(), [](const Waiting& one) { return isQuick(one.asked.request); })) {
      takeAnswers(prepare(draft_ ? *draft_ : present(), allAsked(), options_.read, cost::kNeverCancelled));
    } else if (job_.busy()) {
      dropWork();
    } else {
      startPreparing();
    }
  }
  if (job_.busy()) return;
  if (draft_) {
    build();
  } else if (seek_) {
    startSeeking();
  }
}

void Session::startPreparing() {
  const std::vector<Asked> asked = allAsked();
  job_.start(
      [draft = draft_ ? *draft_ : present(), asked, read = options_.read](const std::atomic<bool>& cancelled) mutable {
        return Outcome(prepare(std::move(draft), asked, read, cancelled));
      });
  work_ = {Work::Kind::preparing, false, asked.size()};
}

void Session::build() {
  const Redraw redraw = draft_->all || draft_->redraw ? Redraw::always : Redraw::where_it_has_to_be;
  std::vector<const Body*> replaced;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (draft_->all || draft_->bodies.count(i) > 0) replaced.push_back(bodies_[i].get());
  }
  BuildOrder order = wholeScene(draft_->scene, options_.rate, options_.companions(replaced, redraw));
  if (!draft_->all) order.bodies.assign(draft_->bodies.begin(), draft_->bodies.end());
  order.time = comingTime();
  job_.start([order = std::move(order)](const std::atomic<bool>& cancelled) mutable {
    return Outcome(session::build(std::move(order), cancelled));
  });
  work_ = {Work::Kind::building, false, 0};
}

void Session::startSeeking() {
  std::vector<Motion> motions;
  for (const auto& body : bodies_) motions.push_back(body->motion());
  job_.start([motions = std::move(motions), time = *seek_](const std::atomic<bool>& cancelled) mutable {
    return Outcome(advanced(std::move(motions), time, cancelled));
  });
  work_ = {Work::Kind::seeking, false, 0};
}

double Session::comingTime() const {
  return draft_->from_start ? 0 : clock_.comingTime();
}

void Session::dropWork() {
  if (!job_.busy()) return;
  work_.stale = true;
  job_.cancel();
}

void Session::stopSeeking() {
  seek_.reset();
  if (work_.kind == Work::Kind::seeking) dropWork();
}

void Session::takeAnswers(Prepared&& prepared) {
  const std::size_t count = prepared.answers.size();
  const std::vector<Waiting> asked(std::make_move_iterator(queue_.begin()),
                                   std::make_move_iterator(queue_.begin() + static_cast<std::ptrdiff_t>(count)));
  queue_.erase(queue_.begin(), queue_.begin() + static_cast<std::ptrdiff_t>(count));
  bool changed = false;
  for (std::size_t k = 0; k < count; ++k) {
    Answer& answer = prepared.answers[k];
    if (answer.refusal) {
      answer.refusal->requests = {asked[k].asked.request};
      refuse(*answer.refusal);
    } else {
      changed = changed || !std::holds_alternative<Seek>(asked[k].asked.request);
      for (const std::string& warning : answer.warnings) listener_.warned(warning);
    }
  }
  std::optional<double> sought;  // at once: nothing that begins at t = 0 would undo it
  if (!prepared.draft.from_start) sought = std::exchange(prepared.draft.seek, std::nullopt);
  if (changed) {
    if (prepared.draft.all) endDrag();
    draft_ = std::move(prepared.draft);
    dropWork();
  } else if (draft_ && prepared.draft.seek) {
    draft_->seek = prepared.draft.seek;
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (asked[k].reply) asked[k].reply(prepared.answers[k]);
  }
  if (sought) seek(*sought);
}

void Session::takeOutcome() {
  std::optional<Outcome> outcome;
  std::string problem;
  try {
    outcome = job_.poll();
    if (!outcome) return;
  } catch (const std::exception& error) {
    problem = error.what();
  }
  const Work done = std::exchange(work_, {});
  if (done.stale) return;
  switch (done.kind) {
    case Work::Kind::preparing:
      takeAnswers(outcome ? std::get<Prepared>(std::move(*outcome)) : nothingPrepared(done.asked, problem));
      return;
    case Work::Kind::building:
      if (outcome) {
        takeBuilt(std::get<Built>(std::move(*outcome)));
      } else {
        giveUpDraft(refusalOf(Reason::cannot_be_made, {}, problem));
      }
      return;
    case Work::Kind::seeking:
      if (outcome) {
        Advanced& there = std::get<Advanced>(*outcome);
        seek_.reset();
        for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i]->replaceMotion(std::move(there.motions[i]));
        jumpTo(there.time);
      } else {
        refuse(refusalOf(Reason::no_state, {Seek{*std::exchange(seek_, std::nullopt)}}, problem));
      }
      return;
    case Work::Kind::none:
      return;
  }
}

void Session::takeBuilt(Built&& built) {
  if (std::optional<Refusal> refusal = tooCostly(built)) {
    giveUpDraft(std::move(*refusal));
    return;
  }
  // t has gone on meanwhile, and may have been sent far away.
  if (stepsTo(built.bodies, comingTime()) <= kMostTickSteps) {
    exchange(std::move(built));
    return;
  }
  job_.start(
      [built = std::make_shared<Built>(std::move(built)), time = comingTime()](const std::atomic<bool>& cancelled) {
        advance(*built, time, cancelled);
        return Outcome(std::move(*built));
      });
  work_ = {Work::Kind::building, false, 0};
}

void Session::giveUpDraft(Refusal refusal) {
  const Draft draft = *std::exchange(draft_, std::nullopt);
  if (draft.reset) clock_.jumpTo(0);
  if (draft.seek) seek(*draft.seek);
  refusal.requests = draft.requests;
  refuse(std::move(refusal));
  endDrag();
}

void Session::exchange(Built&& built) {
  for (const std::string& choice : built.choices) listener_.chose(choice);
  const double time = comingTime();
  Draft draft = *std::exchange(draft_, std::nullopt);
  std::vector<std::string> names;
  for (const auto& body : built.bodies) names.push_back(body->name());
  if (draft.all || std::find(names.begin(), names.end(), drag_.body()) != names.end()) preview_.reset();
  endDrag();
  if (draft.all) {
    bodies_ = std::move(built.bodies);
  } else {
    for (std::size_t k = 0; k < built.indices.size(); ++k) {
      built.bodies[k]->stand(time);
      bodies_[built.indices[k]] = std::move(built.bodies[k]);
    }
  }
  playing_ = {std::move(built.scene), std::move(draft.name), std::move(draft.file)};
  start_scene_ = std::move(draft.start_scene);
  if (draft.from_start) {
    clock_.jumpTo(0);
    seek_ = draft.seek;
  } else {
    clock_.beginSegment();
  }
  refusal_.reset();
  listener_.bodiesChanged(names, draft.all);
  if (const std::optional<double> sought = std::exchange(seek_, std::nullopt)) seek(*sought);  // with what moves now
}

}  // namespace poinsot::session
