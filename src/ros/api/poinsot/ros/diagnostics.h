#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "poinsot/ros/tick_timer.h"
#include "poinsot/session/session.h"

namespace poinsot::node {

/** Publishes /diagnostics: how regularly the node ticks, and how accurate each body's motion is. */
class Diagnostics {
 public:
  /** @param rate that was asked for [Hz]. timer and session outlive it. */
  Diagnostics(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle, double rate, TickTimer& timer,
              const session::Session& session);

  /** To be called when other bodies play. */
  void bodiesChanged();
  /** Publishes when it is due. */
  void update() { updater_.update(); }
  /** Publishes now. */
  void publish() { updater_.force_update(); }

 private:
  void tell(const session::Body& body, diagnostic_updater::DiagnosticStatusWrapper& status) const;
  void tellTicks(diagnostic_updater::DiagnosticStatusWrapper& status);

  double rate_;
  TickTimer& timer_;
  const session::Session& session_;
  diagnostic_updater::Updater updater_;
  std::vector<std::string> tasks_;  ///< of the bodies
};

}  // namespace poinsot::node
