#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>

#include <string>
#include <vector>

#include "poinsot/ros/tick_timer.h"
#include "poinsot/session/session.h"

namespace poinsot::node {

/** /diagnostics: how regularly the node ticks, and how each body fares. */
class Diagnostics {
 public:
  /** @param rate that was asked for [Hz]; all outlive it. */
  Diagnostics(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle, double rate, TickTimer& timer,
              const session::Session& session);

  /** The bodies are others now. */
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
