// A hand on a body's spin, from taking hold to what comes of it.
#include "played.h"

namespace poinsot::session {
namespace {

using Kind = HandleEvent::Kind;

const Eigen::Vector3d kNowhere = Eigen::Vector3d::Zero();

class Drag : public Played {
 protected:
  void touch(Kind kind, const Eigen::Vector3d& point = Eigen::Vector3d::Zero(), const std::string& name = "wing") {
    HandleEvent event = on(name, kind);
    event.point = point;
    send(event);
  }
  static HandleEvent on(const std::string& name, Kind kind) {
    HandleEvent out;
    out.kind = kind;
    out.body = name;
    out.frame = name + "_model";
    return out;
  }
  void send(const HandleEvent& event) { session->touch(event, wall, eye, "wing_model"); }
  SpinDrag::State state() const { return session->drag().state(); }
  double energy(const Eigen::Vector3d& omega) const {
    return 0.5 * omega.dot(body("wing").inertia.moments().cwiseProduct(omega));
  }
  double momentum(const Eigen::Vector3d& omega) const {
    return body("wing").inertia.moments().cwiseProduct(omega).norm();
  }

  std::optional<Eigen::Vector3d> eye;
};

TEST_F(Drag, aHeldBodyStandsStillAndGoesOnWhenItIsLetGo) {
  touch(Kind::press);
  EXPECT_TRUE(session->clock().paused());
  touch(Kind::let_go);
  EXPECT_FALSE(session->clock().paused());
  EXPECT_EQ(state(), SpinDrag::State::free);
  EXPECT_FALSE(job.busy()) << "a click changes nothing";
}

TEST_F(Drag, pausedBeforeIsPausedAfterAndAPauseMeanwhileHoldsAfterwards) {
  ask(Pause{true});
  touch(Kind::press);
  touch(Kind::let_go);
  EXPECT_TRUE(session->clock().paused());
  ask(Pause{false});
  touch(Kind::press);
  ask(Pause{true});
  touch(Kind::let_go);
  EXPECT_TRUE(session->clock().paused());
}

TEST_F(Drag, aHandThatHardlyMovesLeadsNothing) {
  touch(Kind::press);
  touch(Kind::lead, omegaPoint(bodyNamed("wing")) + Eigen::Vector3d(0, 0.004, 0));
  EXPECT_EQ(state(), SpinDrag::State::pressed);
  EXPECT_EQ(heard.previews, 0);
}

TEST_F(Drag, omegaIsLedOverTheEnergyEllipsoidAndStartsThere) {
  const double before = energy(bodyNamed("wing").state().omega_body);
  touch(Kind::press);
  touch(Kind::lead, {0.1, 0, 0.9});
  EXPECT_EQ(state(), SpinDrag::State::led);
  EXPECT_EQ(heard.previews, 1);
  ASSERT_TRUE(session->preview());
  EXPECT_EQ(&session->drawn(0), session->preview());
  EXPECT_NE(&session->drawn(1), session->preview());
  const Eigen::Vector3d led = session->preview()->state().omega_body;
  EXPECT_NEAR(energy(led), before, 1e-12);
  EXPECT_LT(led.normalized().cross(Eigen::Vector3d(0.1, 0, 0.9).normalized()).norm(), 1e-12);
  const Status status = session->status();
  ASSERT_TRUE(status.bodies[0].held);
  EXPECT_NEAR(status.bodies[0].held->kinetic_energy, before, 1e-12);
  EXPECT_NEAR(std::sqrt(status.bodies[0].held->momentum_squared), momentum(led), 1e-12);
  EXPECT_FALSE(status.bodies[1].held);
  touch(Kind::let_go);
  EXPECT_EQ(state(), SpinDrag::State::let_go);
  EXPECT_TRUE(session->clock().paused()) << "until it is ready";
  work();
  EXPECT_LT((bodyNamed("wing").motion().setup().omega_body - led).norm(), 1e-14);
  EXPECT_FALSE(session->clock().paused());
  EXPECT_FALSE(session->preview());
  EXPECT_FALSE(session->status().bodies[0].held);
  EXPECT_EQ(heard.previews_ended, 0) << "other bodies are drawn now: bodiesChanged says so";
}

TEST_F(Drag, omegaIsLedOverTheMomentumEllipsoidWhereThatWasChosen) {
  HandleEvent keep = on("wing", Kind::keep);
  keep.keep = view::ConservedQuantity::momentum;
  send(keep);
  EXPECT_EQ(heard.kept, view::ConservedQuantity::momentum);
  const Eigen::Vector3d moments(1, 2, 3);
  const double before = moments.cwiseProduct(bodyNamed("wing").state().omega_body).norm();
  touch(Kind::lead, {0.5, 0.1, 0.3});
  EXPECT_NEAR(moments.cwiseProduct(session->preview()->state().omega_body).norm(), before, 1e-12);
}

TEST_F(Drag, aHandLeadsInTheAxesOfTheBodyNotInThePrincipalOnes) {
  Eigen::Matrix3d tensor;
  tensor << 2, 0.3, -0.2, 0.3, 3, 0.4, -0.2, 0.4, 4;
  scene::Scene scene = twoBodies();
  scene.bodies[0].inertia = PrincipalInertia::fromTensor(tensor);
  play(scene);
  const Eigen::Vector3d before = bodyNamed("wing").state().omega_body, point(0.5, -0.2, 0.6);
  touch(Kind::lead, point);
  const Eigen::Vector3d led = session->preview()->state().omega_body;
  EXPECT_NEAR(led.dot(tensor * led), before.dot(tensor * before), 1e-12) << "E stays";
  EXPECT_LT(led.normalized().cross(point.normalized()).norm(), 1e-12) << "in the direction of the hand";
}

TEST_F(Drag, withAnEyeOmegaLiesInTheLineOfSight) {
  eye = Eigen::Vector3d(10, 0, 0);
  touch(Kind::lead, {0.3, 0.1, 0.05});
  const Eigen::Vector3d led = 0.5 * session->preview()->state().omega_body;  // metres
  EXPECT_LT((led - *eye).normalized().cross((Eigen::Vector3d(0.3, 0.1, 0.05) - *eye).normalized()).norm(), 1e-12);
}

TEST_F(Drag, aHandThatIsGoneLetsGo) {
  touch(Kind::press);
  wall += 2 * kSecond;
  touch(Kind::hold);
  wall += 2 * kSecond;
  session->serve(wall);
  EXPECT_EQ(state(), SpinDrag::State::pressed) << "it said that it still holds";
  wall += 2 * kSecond;
  session->serve(wall);
  EXPECT_EQ(heard.gone, "wing");
  EXPECT_FALSE(session->clock().paused());
}

TEST_F(Drag, forbiddenPlacesAreRefusedAndTheLastGoodOneCounts) {
  touch(Kind::press);
  touch(Kind::lead, {0, 0, 0.9});
  touch(Kind::lead, {0, 0, 0});
  touch(Kind::lead, {NAN, 0, 0});
  EXPECT_EQ(heard.refusals.size(), 2u);
  touch(Kind::let_go);
  work();
  EXPECT_GT(bodyNamed("wing").motion().setup().omega_body.z(), 0.5);
}

TEST_F(Drag, aPlaceInAnotherFrameAndAnUnknownBodyAreRefused) {
  HandleEvent event = on("wing", Kind::lead);
  event.frame = "world";
  event.point = {0, 0, 1};
  send(event);
  touch(Kind::press, kNowhere, "nobody");
  ASSERT_EQ(heard.refusals.size(), 2u);
  EXPECT_NE(heard.refusals[0].detail.find("wing_model"), std::string::npos);
  EXPECT_EQ(state(), SpinDrag::State::free);
}

TEST_F(Drag, whatIsLedToIsRefusedWhileAnotherSceneIsMadeReady) {
  touch(Kind::lead, {0, 0, 0.9});
  ask(LoadScene{"second"});
  touch(Kind::let_go);
  EXPECT_EQ(heard.refusals.size(), 1u);
  EXPECT_EQ(state(), SpinDrag::State::free);
  EXPECT_FALSE(session->clock().paused());
  EXPECT_EQ(heard.previews_ended, 1);
}

TEST_F(Drag, aSecondHandTakesTheFirstOnesPlace) {
  touch(Kind::press);
  touch(Kind::lead, {0, 0, 0.9});
  touch(Kind::press, kNowhere, "wing2");
  EXPECT_TRUE(session->drag().isOn("wing2"));
  EXPECT_EQ(heard.previews_ended, 1);
  touch(Kind::let_go, kNowhere, "wing2");
  EXPECT_FALSE(session->clock().paused()) << "as it was before the first";
}

TEST_F(Drag, anotherBodysChangeEndsItAndWhatIsDrawnOfItGoes) {
  touch(Kind::lead, {0, 0, 0.9});
  ask(SetMethod{"wing2", "rk4", 0.01});
  work();
  EXPECT_EQ(state(), SpinDrag::State::free);
  EXPECT_FALSE(session->preview());
  EXPECT_EQ(heard.previews_ended, 1);
  EXPECT_EQ(heard.changed, std::vector<std::string>{"wing2"});
}

TEST_F(Drag, chosenSpinsBegin) {
  HandleEvent event = on("wing", Kind::axis);
  event.axis = view::Axis::largest;
  send(event);
  work();
  const Eigen::Vector3d omega = bodyNamed("wing").motion().setup().omega_body;
  EXPECT_EQ(omega.head<2>().norm(), 0);
  touch(Kind::reset);
  work();
  EXPECT_EQ(bodyNamed("wing").motion().setup().omega_body, body("wing").omega_body);
}

}  // namespace
}  // namespace poinsot::session
