#include "poinsot/ros/services.h"

#include <boost/make_shared.hpp>
#include <chrono>
#include <future>
#include <memory>
#include <stdexcept>
#include <utility>

#include "poinsot/core/number_text.h"
#include "poinsot/ros/names.h"
#include "poinsot/ros/session_text.h"

namespace poinsot::node {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks{50};  // at whether the node ends
constexpr std::chrono::seconds kAnswerPatience{60};     // far longer than the largest scene takes to be read

/** One request in the session's queue. */
class Posted : public ros::CallbackInterface {
 public:
  Posted(session::Request request, Services::Ask ask) : request_(std::move(request)), ask_(std::move(ask)) {}

  std::future<session::Answer> answer() { return answer_->get_future(); }

  CallResult call() override {
    try {
      ask_(request_, [answer = answer_](const session::Answer& given) { answer->set_value(given); });
    } catch (const std::exception&) {
      // The caller is told. Where the answer has been given, the fault belongs to a request that follows.
      try {
        answer_->set_exception(std::current_exception());
      } catch (const std::future_error&) {
      }
    }
    return Success;
  }

 private:
  session::Request request_;
  Services::Ask ask_;
  std::shared_ptr<std::promise<session::Answer>> answer_ = std::make_shared<std::promise<session::Answer>>();
};

}  // namespace

Services::Services(const ros::NodeHandle& private_handle, double rate, ros::CallbackQueue& session_queue, Ask ask,
                   const std::atomic<bool>& interrupted)
    : rate_(rate),
      session_queue_(session_queue),
      ask_(std::move(ask)),
      interrupted_(interrupted),
      handle_(private_handle),
      spinner_(1, &queue_) {
  handle_.setCallbackQueue(&queue_);
  servers_ = {handle_.advertiseService(names::kPause, &Services::onPause, this),
              handle_.advertiseService(names::kStep, &Services::onStep, this),
              handle_.advertiseService(names::kReset, &Services::onReset, this),
              handle_.advertiseService(names::kLoadScene, &Services::onLoadScene, this),
              handle_.advertiseService(names::kSetMethod, &Services::onSetMethod, this),
              handle_.advertiseService(names::kSetSpin, &Services::onSetSpin, this)};
  spinner_.start();
}

Services::~Services() {
  ended_ = true;
  spinner_.stop();
}

session::Answer Services::answerTo(const session::Request& request) {
  const auto posted = boost::make_shared<Posted>(request, ask_);
  std::future<session::Answer> answer = posted->answer();
  session_queue_.addCallback(posted);
  const auto end = std::chrono::steady_clock::now() + kAnswerPatience;
  while (answer.wait_for(kBetweenLooks) != std::future_status::ready) {
    if (ended_ || interrupted_) throw std::runtime_error("the node is ending");
    if (std::chrono::steady_clock::now() > end) {
      throw std::runtime_error("expected an answer within " + std::to_string(kAnswerPatience.count()) +
                               " s, got none; what was asked for is still being worked out");
    }
  }
  return answer.get();
}

template <class Response, class Words>
bool Services::respond(const session::Request& request, Response& response, const Words& words) {
  try {
    const session::Answer answer = answerTo(request);
    response.success = !answer.refusal;
    response.message = answer.refusal ? textOf(*answer.refusal) : words(answer);
  } catch (const std::exception& error) {
    response.success = false;
    response.message = error.what();
  }
  return true;
}

bool Services::onPause(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
  return respond(session::Pause{request.data != 0}, response, [&](const session::Answer&) {
    return request.data ? "paused" : "playing";  // where, the next tick tells
  });
}

bool Services::onStep(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  return respond(session::Step{}, response,
                 [&](const session::Answer&) { return "advancing by " + numberText(1 / rate_) + " s"; });
}

bool Services::onReset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  return respond(session::Reset{}, response, [](const session::Answer& answer) {
    return answer.spins               ? "going back to t = 0 and the scene's own spins"
           : answer.in_the_background ? "going back to t = 0"
                                      : "back to t = 0";
  });
}

bool Services::onLoadScene(LoadScene::Request& request, LoadScene::Response& response) {
  return respond(session::LoadScene{request.scene}, response,
                 [](const session::Answer& answer) { return "scene " + answer.scene + " is being made ready"; });
}

bool Services::onSetMethod(SetMethod::Request& request, SetMethod::Response& response) {
  const std::optional<double> step = request.step == 0 ? std::nullopt : std::make_optional(request.step);
  return respond(session::SetMethod{request.body, request.method, step}, response, [&](const session::Answer& answer) {
    std::string out = request.body + ": " + answer.method;
    if (answer.step) out += " with a step of " + numberText(*answer.step) + " s";
    for (const std::string& warning : answer.warnings) out += "; " + warning;
    return out;
  });
}

bool Services::onSetSpin(SetSpin::Request& request, SetSpin::Response& response) {
  const geometry_msgs::Vector3& omega = request.omega_body;
  return respond(session::SetSpin{request.body, {omega.x, omega.y, omega.z}}, response,
                 [](const session::Answer&) { return ""; });
}

}  // namespace poinsot::node
