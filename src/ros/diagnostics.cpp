#include "poinsot/ros/diagnostics.h"

#include "poinsot/core/number_text.h"

namespace poinsot::node {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

constexpr double kAstray = 0.1;     // rad from the closed form: beyond, a warning
constexpr double kLateShare = 0.9;  // of the rate that was asked for: below, a warning

}  // namespace

Diagnostics::Diagnostics(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle, double rate,
                         TickTimer& timer, const session::Session& session)
    : rate_(rate), timer_(timer), session_(session), updater_(handle, private_handle) {
  updater_.setHardwareID("none");
  updater_.add("ticks", this, &Diagnostics::tellTicks);
  bodiesChanged();
}

void Diagnostics::bodiesChanged() {
  for (const std::string& task : tasks_) updater_.removeByName(task);
  tasks_.clear();
  for (std::size_t i = 0; i < session_.bodies().size(); ++i) {
    tasks_.push_back("body " + session_.bodies()[i]->name());
    updater_.add(tasks_.back(), [this, i](DiagnosticStatusWrapper& status) { tell(*session_.bodies()[i], status); });
  }
}

void Diagnostics::tell(const session::Body& body, DiagnosticStatusWrapper& status) const {
  const MotionSetup& setup = body.motion().setup();
  const std::string step = setup.step ? ", step " + numberText(*setup.step) + " s" : "";
  const double error = body.attitudeError();
  const bool astray = error > kAstray;
  status.summary(astray ? DiagnosticStatus::WARN : DiagnosticStatus::OK,
                 setup.method + step + (astray ? ": " + numberText(error) + " rad astray" : ""));
  status.addf("simulation time [s]", "%.9g", body.state().time);
  if (!body.motion().torques()) status.addf("attitude error [rad]", "%.3g", error);
  status.addf("energy [J]", "%.6g", body.state().kinetic_energy);
  status.addf("energy drift", "%.3g", body.energyDrift());
  status.addf("momentum drift", "%.3g", body.momentumDrift());
  status.addf("cost [CPU s per simulated s]", "%.3g", body.cost());
}

void Diagnostics::tellTicks(DiagnosticStatusWrapper& status) {
  const Punctuality p = timer_.takePunctuality();
  const bool late = p.ticks > 0 && p.rate < kLateShare * rate_ && timer_.mode() != TickTimer::Mode::foreign_clock;
  status.summary(late ? DiagnosticStatus::WARN : DiagnosticStatus::OK, late ? "slower than asked" : "on time");
  status.addf("rate asked [Hz]", "%g", rate_);
  status.addf("rate [Hz]", "%.6g", p.rate);
  status.addf("jitter, standard deviation [s]", "%.3g", p.jitter);
  status.addf("lateness, mean [s]", "%.3g", p.mean_lateness);
  status.addf("lateness, worst [s]", "%.3g", p.worst);
  status.add("paused", session_.clock().paused() ? "yes" : "no");
  status.addf("speed", "%g", session_.clock().speed());
}

}  // namespace poinsot::node
