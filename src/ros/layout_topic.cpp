#include "poinsot/ros/layout_topic.h"

#include <algorithm>
#include <string>
#include <vector>

#include "poinsot/ros/body_topics.h"
#include "poinsot/ros/layout_message.h"
#include "poinsot/ros/markers/drawings.h"
#include "poinsot/ros/names.h"

namespace poinsot::node {
namespace {

const ros::WallDuration kPause(0.1);

std::vector<LaidOut> bodiesOf(const session::Session& session) {
  std::vector<LaidOut> out;
  for (const auto& body : session.bodies()) {
    BodyTopics& topics = topicsOf(*body);
    const BodyPicture& picture = topics.picture();
    out.push_back(
        {body->name(), topics.frames().body, picture.hasPictures(), {body->state().position, picture.reach()}});
  }
  return out;
}

}  // namespace

LayoutTopic::LayoutTopic(ros::NodeHandle private_handle)
    : publisher_(private_handle.advertise<SceneLayout>(names::kLayout, 1, true)) {}

void LayoutTopic::layOut(const session::Session& session) {
  std::vector<BodyPicture*> pictures;
  SceneFacts facts;
  for (const auto& body : session.bodies()) {
    pictures.push_back(&topicsOf(*body).picture());
    facts.some_body_steps = facts.some_body_steps || !body->motion().inClosedForm();
  }
  facts.loop = session.scene().loop;
  facts.light_background = light_background_;
  layout_ = layOutScene(pictures, facts);
  extendOverview(session.scene().drawings, layout_);
}

void LayoutTopic::appendDrawings(const session::Session& session, visualization_msgs::MarkerArray& out) const {
  node::appendDrawings(session.scene().drawings, layout_, light_background_, out);
}

void LayoutTopic::publish(const session::Session& session) {
  const std::vector<LaidOut> bodies = bodiesOf(session);
  away_ = hasFlownAway(layout_, bodies);
  sent_ = ros::SteadyTime::now();
  publisher_.publish(layoutMessage(layout_, bodies));
}

void LayoutTopic::follow(const session::Session& session) {
  const bool may_fly = std::any_of(session.bodies().begin(), session.bodies().end(),
                                   [](const auto& body) { return !body->state().velocity.isZero(0); });
  if ((!may_fly && !away_) || ros::SteadyTime::now() - sent_ < kPause) return;
  if (away_ || hasFlownAway(layout_, bodiesOf(session))) publish(session);
}

}  // namespace poinsot::node
