#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/cost/cancelled.h"
#include "poinsot/session/session.h"

/** A session whose job and clocks do only what a test tells them. */
namespace poinsot::session {

/** Runs its work when it is told to. */
class FakeJob : public Job {
 public:
  void start(Work work) override {
    ASSERT_FALSE(work_) << "one piece of work at a time";
    work_ = std::move(work);
    cancelled_ = false;
    ++started;
  }
  bool busy() const override { return static_cast<bool>(work_); }
  void cancel() override {
    if (work_) cancelled_ = true;
  }
  std::optional<Outcome> poll() override {
    if (!work_ || !may_end_) return std::nullopt;
    may_end_ = false;
    const Work work = std::exchange(work_, nullptr);
    if (outcome_) return std::exchange(outcome_, std::nullopt);
    return work(cancelled_);
  }

  /** What it does is done now, and can be polled. */
  void endNow() {
    outcome_ = work_(cancelled_);
    may_end_ = true;
  }

  /** What it does now is done by the next poll(). */
  void end() { may_end_ = true; }
  bool isCancelled() const { return cancelled_; }

  int started = 0;

 private:
  Work work_;
  std::optional<Outcome> outcome_;
  std::atomic<bool> cancelled_{false};
  bool may_end_ = false;
};

/** Writes down what it is told. */
class Heard : public Listener {
 public:
  void bodiesChanged(const std::vector<std::string>& names, bool another_scene) override {
    changes.push_back(another_scene);
    changed = names;
  }
  void previewChanged(const std::string&) override { ++previews; }
  void previewEnded(const std::string&) override { ++previews_ended; }
  void keepsAnotherEllipsoid(view::ConservedQuantity keep) override { kept = keep; }
  void refused(const Refusal& refusal) override { refusals.push_back(refusal); }
  void warned(const std::string& warning) override { warnings.push_back(warning); }
  void chose(const std::string& choice) override { choices.push_back(choice); }
  void seeksFar(double time, double) override { far_seeks.push_back(time); }
  void timeIsCoarse(double, double) override { ++coarse; }
  void handIsGone(const std::string& body) override { gone = body; }
  void stampsJumpedBack() override { ++jumps_back; }
  void stampsJumpedAhead(double by) override { jumps_ahead.push_back(by); }
  void timeLeftTheRange(double, double) override { ++left_range; }

  std::vector<bool> changes;         ///< whether each was another scene
  std::vector<std::string> changed;  ///< the bodies of the last
  int previews = 0, previews_ended = 0, coarse = 0, jumps_back = 0, left_range = 0;
  view::ConservedQuantity kept = view::ConservedQuantity::energy;
  std::vector<Refusal> refusals;
  std::vector<std::string> warnings, choices;
  std::vector<double> far_seeks, jumps_ahead;
  std::string gone;
};

/** A picture of which one knows only where it stands. */
class Frame : public Companion {
 public:
  Frame() { frame_.scale.metres_per_radian_per_second = 0.5; }
  const view::PictureFrame& frame() const override { return frame_; }

 private:
  view::PictureFrame frame_;
};

/** Two free bodies, "wing" and "wing2", that play. */
class Played : public testing::Test {
 protected:
  Played() { play(twoBodies()); }

  static scene::Body body(const std::string& name) {
    scene::Body out;
    out.name = name;
    out.inertia = PrincipalInertia::fromMoments({1, 2, 3});
    out.omega_body = {0.01, 1, 0.01};
    return out;
  }
  static scene::Scene twoBodies() {
    scene::Scene out;
    out.bodies = {body("wing"), body("wing2")};
    return out;
  }

  void play(const scene::Scene& scene) {
    Session::Options options;
    options.rate = 100;
    options.find = [](const std::string& name) {
      if (name == "none") throw std::runtime_error("there is no scene \"none\"");
      return name[0] == '/' ? name : "/" + name + ".yaml";
    };
    options.read = [this](const std::string& file) {
      if (file == "/bad.yaml") throw std::runtime_error("line 1: not a scene");
      NamedScene out;
      out.scene = to_read;
      out.name = file.substr(1, file.size() - 6);
      out.file = file;
      return out;
    };
    options.companions = [this](const std::vector<const Body*>&, Redraw redraw) {
      redraws.push_back(redraw);
      return [](const scene::Body&, const Motion&) { return std::make_unique<Frame>(); };
    };
    Built built = build(wholeScene(scene, options.rate, options.companions({}, Redraw::always)), cost::kNeverCancelled);
    const NamedScene named{built.scene, "first", "/first.yaml"};
    session = std::make_unique<Session>(options, named, std::move(built), job, heard);
    tick();
  }

  /** Asks, and gives the answer where there is one at once. */
  std::optional<Answer> ask(const Request& request) {
    answers.clear();
    session->ask(request, [this](const Answer& answer) { answers.push_back(answer); });
    return answers.empty() ? std::nullopt : std::make_optional(answers.back());
  }

  /** Lets the job end what it does, as often as it is given something. */
  void work() {
    while (job.busy()) {
      job.end();
      session->serve(wall);
    }
  }
  /** Lets the job end once. */
  void workOnce() {
    ASSERT_TRUE(job.busy());
    job.end();
    session->serve(wall);
  }

  std::optional<Tick> tick(double seconds = 0.01) {
    stamp += static_cast<Nanoseconds>(seconds * 1e9);
    return session->tick(stamp);
  }

  const Body& bodyNamed(const std::string& name) const { return *session->bodies()[indexOf(session->scene(), name)]; }
  std::string methodOf(const std::string& name) const { return bodyNamed(name).motion().setup().method; }
  std::uint32_t segment() const { return session->clock().segment(); }

  scene::Scene to_read = twoBodies();
  FakeJob job;
  Heard heard;
  std::unique_ptr<Session> session;
  std::vector<Redraw> redraws;
  std::vector<Answer> answers;
  Nanoseconds stamp = 1000 * kSecond, wall = 0;
};

}  // namespace poinsot::session
