#pragma once

#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "poinsot/LoadScene.h"
#include "poinsot/SetMethod.h"
#include "poinsot/SetSpin.h"
#include "poinsot/session/session.h"

namespace poinsot::node {

/**
 * The node's services. They have a thread of their own, which posts requests to the session's thread and waits for the
 * answers, so that a call that takes long delays nothing but other calls.
 */
class Services {
 public:
  using Ask = std::function<void(const session::Request&, const session::Session::Reply&)>;

  /**
   * @param rate of the ticks [Hz], for the words of ~step.
   * @param session_queue called in the session's thread.
   * @param ask of the session; called from session_queue.
   * @param interrupted ends the waiting.
   */
  Services(const ros::NodeHandle& private_handle, double rate, ros::CallbackQueue& session_queue, Ask ask,
           const std::atomic<bool>& interrupted);
  /** Calls that wait are answered with a failure. */
  ~Services();

 private:
  /** Asks in the session's thread and returns the answer. Throws std::runtime_error where none comes. */
  session::Answer answerTo(const session::Request& request);
  /** Fills the response in. @param words says what is done. */
  template <class Response, class Words>
  bool respond(const session::Request& request, Response& response, const Words& words);

  bool onPause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response);
  bool onStep(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool onReset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool onLoadScene(LoadScene::Request& request, LoadScene::Response& response);
  bool onSetMethod(SetMethod::Request& request, SetMethod::Response& response);
  bool onSetSpin(SetSpin::Request& request, SetSpin::Response& response);

  double rate_;
  ros::CallbackQueue& session_queue_;
  Ask ask_;
  const std::atomic<bool>& interrupted_;
  std::atomic<bool> ended_{false};
  ros::CallbackQueue queue_;
  ros::NodeHandle handle_;
  std::vector<ros::ServiceServer> servers_;
  ros::AsyncSpinner spinner_;
};

}  // namespace poinsot::node
