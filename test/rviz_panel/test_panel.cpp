// The panel in RViz, driven by mouse and keyboard as a user does, judged by what anybody hears on the node's topics.
// Usage: test_panel PANEL.rviz, on a display where nobody else is.
#include <gtest/gtest.h>
#include <poinsot/SetSpin.h>
#include <ros/master.h>
#include <ros/package.h>
#include <ros/ros.h>
#include <rviz/config.h>
#include <rviz/display.h>
#include <rviz/display_group.h>
#include <rviz/panel.h>
#include <rviz/properties/color_property.h>
#include <rviz/render_panel.h>
#include <rviz/view_controller.h>
#include <rviz/view_manager.h>
#include <rviz/visualization_manager.h>
#include <yaml-cpp/yaml.h>

#include <QAbstractItemView>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSlider>
#include <QTcpServer>
#include <QTest>
#include <QToolButton>
#include <cmath>
#include <memory>

#include "hosted_rviz.h"
#include "node_watcher.h"

namespace {

constexpr double kPatience = 40;  // s, for a machine that is busy
constexpr double kFrame = 1.0 / 60;

QString view_file;
std::unique_ptr<Program> master;
std::unique_ptr<Program> node;
std::unique_ptr<HostedRviz> shown;
std::unique_ptr<NodeWatcher> heard;

void startMaster() {
  const QString port = QString::fromStdString(ros::master::getURI()).section(':', -1).remove('/');
  master = std::make_unique<Program>("rosmaster", QStringList{"--core", "-p", port});
}

void startNode() {
  node = std::make_unique<Program>(
      NODE, QStringList{"__name:=poinsot", QString("_scene_file:=") + SCENES + "/dzhanibekov.yaml"});
}

class Panel : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    shown = std::make_unique<HostedRviz>(view_file);
    heard = std::make_unique<NodeWatcher>("wingnut");
  }
  static void TearDownTestSuite() {
    heard.reset();
    shown.reset();
    node.reset();
  }

  /** Each test begins with the wingnut playing forwards at real time in closed form, except where there is to be no
   * node. */
  void SetUp() override {
    if (!node) startNode();
    node->thaw();
    ASSERT_TRUE(until([] { return controls()->isEnabled(); })) << "the panel does not find the node";
    if (combo("scene")->currentText() != "dzhanibekov") pick("scene", "dzhanibekov");
    ASSERT_TRUE(until([] { return combo("body")->currentText() == "wingnut"; }));
    ASSERT_TRUE(until([] { return heard->states > 0; }));
    if (combo("method")->currentText() != "closed_form") pick("method", "closed_form");
    // At a hundred times real time t would be beyond 5 s before anybody has looked.
    press<QToolButton>("real_time");
    ASSERT_TRUE(untilState([](const auto& state) { return std::abs(state.time_rate) <= 1; }));
    press<QPushButton>("reset");
    ASSERT_TRUE(untilState([](const auto& state) { return std::abs(state.time) < 5; }));
    if (heard->state.time_rate == 0) press<QPushButton>("play");
    if (find<QToolButton>("backwards")->isChecked()) press<QToolButton>("backwards");
    press<QToolButton>("real_time");
    // A body that played backwards when it was reset is a little before t = 0, on the page before.
    ASSERT_TRUE(untilState([](const auto& state) { return state.time_rate == 1 && state.time > 0; }));
    ASSERT_TRUE(until([] { return find<QLabel>("page_from")->text() == "0 s"; }));
    ASSERT_TRUE(until([] { return combo("method")->currentText() == "closed_form"; }));
    // After a test that played backwards t may be below 0 still, and the slider on the page of negative times.
    press<QPushButton>("reset");
    ASSERT_TRUE(untilState([](const auto& state) { return state.time >= 0 && state.time < 5; }));
    ASSERT_TRUE(untilState([](const auto& state) { return state.time > 0.3; }));
    ASSERT_TRUE(until([] { return find<QLabel>("page_from")->text() == "0 s"; }));
  }

  template <typename Widget>
  static Widget* find(const QString& name) {
    return shown->find<Widget>(name);
  }
  static QWidget* controls() { return find<QWidget>("controls"); }
  static QComboBox* combo(const QString& name) { return find<QComboBox>(name); }
  static QString notice() { return find<QLabel>("notice")->text(); }

  /** Of a display of markers; null where nothing of that namespace has come since it was switched on. */
  static rviz::Property* listed(rviz::Display* display, const QString& ns) {
    rviz::Property* const all = display->subProp("Namespaces");
    for (int i = 0; i < all->numChildren(); ++i) {
      if (all->childAt(i)->getName() == ns) return all->childAt(i);
    }
    return nullptr;
  }

  static bool until(const std::function<bool()>& condition) {
    return shown->spinUntil(
        [&] {
          heard->hear();
          return condition();
        },
        kPatience);
  }
  /** Waits for a state, of those sent from now on, that is as wanted. */
  static bool untilState(const std::function<bool(const poinsot::BodyState&)>& wanted) {
    heard->forget();
    return until([&] { return heard->states > 0 && wanted(heard->state); });
  }
  static void spin(double seconds) {
    shown->spin(seconds);
    heard->hear();
  }

  template <typename Widget>
  static void press(const QString& name) {
    QTest::mouseClick(find<Widget>(name), Qt::LeftButton);
  }
  static void type(const QString& name, const QString& text) {
    auto* const edit = find<QLineEdit>(name);
    QTest::mouseClick(edit, Qt::LeftButton);
    edit->setFocus();
    QTest::keySequence(edit, QKeySequence::SelectAll);
    QTest::keyClick(edit, Qt::Key_Delete);
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
  }
  /** Opens a list and clicks on one of its lines. */
  static void pick(const QString& name, const QString& text) {
    QComboBox* const list = combo(name);
    ASSERT_GE(list->findText(text), 0) << name.toStdString() << " does not offer " << text.toStdString();
    QTest::mouseClick(list, Qt::LeftButton);
    spin(2e-3 * QApplication::doubleClickInterval());  // Qt ignores a click that may be the end of the opening one
    QAbstractItemView* const view = list->view();
    ASSERT_TRUE(view->isVisible());
    const QModelIndex line = list->model()->index(list->findText(text), 0);
    view->scrollTo(line);
    QTest::mouseMove(view->viewport(), view->visualRect(line).center());
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, view->visualRect(line).center());
    ASSERT_EQ(list->currentText(), text);
  }
  static void pauseIt() {
    press<QPushButton>("play");
    ASSERT_TRUE(untilState([](const auto& state) { return state.time_rate == 0; }));
    ASSERT_TRUE(until([] { return find<QPushButton>("step")->isEnabled(); }));
  }
};

TEST_F(Panel, pausesAndPlays) {
  press<QPushButton>("play");
  ASSERT_TRUE(untilState([](const auto& state) { return state.time_rate == 0; }));
  const double t = heard->state.time;
  spin(0.5);
  EXPECT_EQ(heard->state.time, t);
  ASSERT_TRUE(until([] { return find<QPushButton>("play")->text().contains("Play"); }));
  QTest::keyClick(find<QPushButton>("play"), Qt::Key_Space);
  EXPECT_TRUE(untilState([](const auto& state) { return state.time_rate == 1; }));
  EXPECT_TRUE(until([] { return find<QPushButton>("play")->text().contains("Pause"); }));
  EXPECT_FALSE(find<QPushButton>("step")->isEnabled()) << "while it plays, there is no step";
}

TEST_F(Panel, stepsAFrameWhilePaused) {
  pauseIt();
  for (int i = 0; i < 3; ++i) {
    const double t = heard->state.time;
    press<QPushButton>("step");
    ASSERT_TRUE(untilState([&](const auto& state) { return state.time > t && state.time_rate == 0; }));
    EXPECT_NEAR(heard->state.time, t + kFrame, 1e-9);
  }
}

TEST_F(Panel, speedIsSetByTheSlider) {
  auto* const slider = find<QSlider>("speed_slider");
  QTest::keyClick(slider, Qt::Key_Home);
  EXPECT_TRUE(untilState([](const auto& state) { return std::abs(state.time_rate - 0.01) < 1e-12; }));
  QTest::keyClick(slider, Qt::Key_End);
  EXPECT_TRUE(untilState([](const auto& state) { return std::abs(state.time_rate - 100) < 1e-9; }));
  EXPECT_EQ(find<QLabel>("speed_text")->text(), "×100");
  QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() / 4, slider->height() / 3));
  EXPECT_TRUE(untilState([](const auto& state) { return state.time_rate > 0.05 && state.time_rate < 0.2; }));
  press<QToolButton>("real_time");
  EXPECT_TRUE(untilState([](const auto& state) { return state.time_rate == 1; }));
}

TEST_F(Panel, playsBackwards) {
  press<QToolButton>("backwards");
  ASSERT_TRUE(untilState([](const auto& state) { return state.time_rate == -1; }));
  const double t = heard->state.time;
  ASSERT_TRUE(untilState([&](const auto& state) { return state.time < t - 1; }));
  ASSERT_TRUE(untilState([](const auto& state) { return state.time < 0; })) << "it plays on before t = 0";
  QTest::keyClick(find<QSlider>("speed_slider"), Qt::Key_End);
  EXPECT_TRUE(untilState([](const auto& state) { return std::abs(state.time_rate + 100) < 1e-9; }));
  press<QToolButton>("backwards");
  EXPECT_TRUE(untilState([](const auto& state) { return std::abs(state.time_rate - 100) < 1e-9; }));
}

TEST_F(Panel, aSpeedFromElsewhereIsShown) {
  ros::NodeHandle handle;
  ros::Publisher speed = handle.advertise<std_msgs::Float64>("/poinsot/speed", 1);
  ASSERT_TRUE(until([&] { return speed.getNumSubscribers() > 0; }));
  std_msgs::Float64 message;
  message.data = -0.1;
  speed.publish(message);
  EXPECT_TRUE(until([] { return find<QLabel>("speed_text")->text() == "×−0.1"; }));
  EXPECT_TRUE(until([] { return find<QToolButton>("backwards")->isChecked(); }));
  // Turned round, it is no other one: the slider's places are too few for that.
  message.data = -0.123;
  speed.publish(message);
  ASSERT_TRUE(untilState([](const auto& state) { return state.time_rate == -0.123; }));
  ASSERT_TRUE(until([] { return find<QLabel>("speed_text")->text() == "×−0.123"; }));
  press<QToolButton>("backwards");
  EXPECT_TRUE(untilState([](const auto& state) { return state.time_rate == 0.123; })) << heard->state.time_rate;
}

TEST_F(Panel, seeksWhilePaused) {
  pauseIt();
  const unsigned segment = heard->state.segment;
  auto* const slider = find<QSlider>("time_slider");
  QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() / 2, slider->height() / 2));
  ASSERT_TRUE(untilState([&](const auto& state) { return state.segment > segment; }));
  EXPECT_NEAR(heard->state.time, 30, 1) << "the middle of a minute";
  EXPECT_EQ(heard->state.time_rate, 0);
  EXPECT_EQ(heard->state.attitude_error, 0);
  QTest::keyClick(slider, Qt::Key_Right);
  const double t = heard->state.time;
  EXPECT_TRUE(untilState([&](const auto& state) { return std::abs(state.time - t - 0.3) < 0.05; }));
}

TEST_F(Panel, seeksWhileItIsDragged) {
  pauseIt();
  auto* const slider = find<QSlider>("time_slider");
  const int y = slider->height() / 2;
  QTest::mousePress(slider, Qt::LeftButton, {}, QPoint(slider->width() / 4, y));
  ASSERT_TRUE(untilState([](const auto& state) { return std::abs(state.time - 15) < 1; }))
      << "before the button is let go";
  heard->forget();
  int moves = 0;
  for (int x = slider->width() / 4; x <= 3 * slider->width() / 4; ++x, ++moves) {
    QTest::mouseMove(slider, QPoint(x, y));
    QMouseEvent move(QEvent::MouseMove, QPoint(x, y), Qt::LeftButton, Qt::LeftButton, {});
    QApplication::sendEvent(slider, &move);
  }
  EXPECT_TRUE(untilState([](const auto& state) { return std::abs(state.time - 45) < 1; })) << "where it was dragged to";
  QTest::mouseRelease(slider, Qt::LeftButton, {}, QPoint(3 * slider->width() / 4, y));
  spin(1);
  EXPECT_NEAR(heard->state.time, 45, 1) << "and there it stays";
  EXPECT_EQ(heard->state.time_rate, 0);
  std::cout << moves << " moves, " << heard->seeks << " seeks after the first\n";
}

TEST_F(Panel, theSliderFollowsTheTime) {
  type("time", "57");
  ASSERT_TRUE(untilState([](const auto& state) { return state.time >= 57 && state.time < 60; }));
  auto* const slider = find<QSlider>("time_slider");
  EXPECT_TRUE(until([&] { return slider->value() > 0.94 * slider->maximum(); }));
  EXPECT_TRUE(until([&] { return slider->value() < 0.1 * slider->maximum(); })) << "beyond its end it turns the page";
  EXPECT_EQ(find<QLabel>("page_from")->text(), "60 s");
}

TEST_F(Panel, seeksToATimeThatIsTyped) {
  pauseIt();
  type("time", "1e9");
  EXPECT_TRUE(untilState([](const auto& state) { return state.time == 1e9; }));
  type("time", "-12,5");
  EXPECT_TRUE(untilState([](const auto& state) { return state.time == -12.5; }));
  heard->forget();
  type("time", "soon");
  EXPECT_TRUE(until([] { return notice().contains("soon"); }));
  spin(0.5);
  EXPECT_EQ(heard->seeks, 0);
  EXPECT_EQ(heard->state.time, -12.5);
}

TEST_F(Panel, aTimeIsTypedOverTheOneThatRuns) {
  auto* const edit = find<QLineEdit>("time");
  const auto typed = [&](const QString& text) {
    QTest::mouseClick(edit, Qt::LeftButton);
    spin(1);  // t goes on
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
  };
  typed("abc");
  EXPECT_TRUE(until([] { return notice().contains("“abc”"); })) << notice().toStdString();
  typed("1e6");
  EXPECT_TRUE(untilState([](const auto& state) { return state.time >= 1e6 && state.time < 1e6 + 10; }))
      << heard->state.time;
  // It runs again; also when it was clicked and left alone.
  const QString before = edit->text();
  EXPECT_TRUE(until([&] { return edit->text() != before; }));
  QTest::mouseClick(edit, Qt::LeftButton);
  const QString held = edit->text();
  spin(0.5);
  EXPECT_EQ(edit->text(), held);
  QTest::keyClick(edit, Qt::Key_Escape);
  EXPECT_TRUE(until([&] { return edit->text() != held; }));
}

TEST_F(Panel, negativeTimesAreOnTheSlider) {
  pauseIt();
  press<QToolButton>("both_sides");
  auto* const slider = find<QSlider>("time_slider");
  QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() / 4, slider->height() / 2));
  EXPECT_TRUE(untilState([](const auto& state) { return std::abs(state.time + 30) < 2; }));
  press<QToolButton>("both_sides");
}

TEST_F(Panel, resets) {
  type("time", "1000");
  ASSERT_TRUE(untilState([](const auto& state) { return state.time >= 1000; }));
  press<QPushButton>("reset");
  EXPECT_TRUE(untilState([](const auto& state) { return state.time >= 0 && state.time < 30; }));
  EXPECT_EQ(heard->state.time_rate, 1);
}

TEST_F(Panel, resetsToPlayForwards) {
  press<QToolButton>("backwards");
  ASSERT_TRUE(untilState([](const auto& state) { return state.time_rate == -1 && state.time < 0; }));
  press<QPushButton>("reset");
  EXPECT_TRUE(untilState([](const auto& state) { return state.time_rate == 1 && state.time > 0 && state.time < 30; }));
  EXPECT_FALSE(find<QToolButton>("backwards")->isChecked());
}

TEST_F(Panel, aMethodThatDriftsIsSeenToDrift) {
  EXPECT_TRUE(until([] { return find<QLabel>("attitude_error")->text() == "0 rad"; }));
  pick("method", "lie_euler");
  ASSERT_TRUE(until([] { return heard->description.method == "lie_euler"; }));
  ASSERT_TRUE(untilState([](const auto& state) { return state.attitude_error > 0; }));
  const double error = heard->state.attitude_error;
  const double drift = std::abs(heard->state.energy_drift);
  type("time", "40");
  ASSERT_TRUE(untilState([](const auto& state) { return state.time >= 40 && state.time_rate == 1; }));
  EXPECT_TRUE(untilState([&](const auto& state) { return state.attitude_error > 2 * error; }));
  std::cout << "error " << error << " -> " << heard->state.attitude_error << ", drift " << drift << " -> "
            << heard->state.energy_drift << "\n";
  EXPECT_TRUE(until([] {
    const QString text = find<QLabel>("attitude_error")->text();
    return text.endsWith(" rad") && text != "0 rad";
  }));
  EXPECT_TRUE(until([] { return find<QLineEdit>("method_step")->isEnabled(); }));
  EXPECT_TRUE(until([] { return find<QLabel>("flips_title")->text() == "true flips"; }));
  spin(3);
  shown->picture("panel_lie_euler");
  pick("method", "closed_form");
  EXPECT_TRUE(untilState([](const auto& state) { return state.attitude_error == 0; }));
}

TEST_F(Panel, aStepIsSetOrRefused) {
  pick("method", "rk4");
  ASSERT_TRUE(until([] { return heard->description.method == "rk4" && find<QLineEdit>("method_step")->isEnabled(); }));
  spin(1);
  type("method_step", "2.5");
  ASSERT_TRUE(until([] { return std::abs(heard->description.step - 0.0025) < 1e-15; }));
  spin(1);
  for (const char* bad : {"much", "-1", "0", "nan"}) {
    type("method_step", bad);
    EXPECT_TRUE(until([&] { return notice().contains(bad); })) << bad << ": " << notice().toStdString();
    spin(1);
    EXPECT_NEAR(heard->description.step, 0.0025, 1e-15) << bad;
  }
  const QString before = notice();
  type("method_step", "1e7");  // what the node has to judge: it could not follow the body at all
  EXPECT_TRUE(until([&] { return notice() != before && notice().contains("rk4"); })) << notice().toStdString();
  std::cout << notice().toStdString() << "\n";
  spin(1);
  EXPECT_NEAR(heard->description.step, 0.0025, 1e-15);
  EXPECT_TRUE(until([] { return find<QLineEdit>("method_step")->text() == "2.5"; }))
      << "what is in force is shown again";
  type("method_step", "");
  EXPECT_TRUE(until([] { return std::abs(heard->description.step - 0.0025) > 1e-9; })) << "chosen by the node";
}

TEST_F(Panel, theSceneChangesWhilePlaying) {
  YAML::Node scene = YAML::LoadFile(std::string(SCENES) + "/regimes.yaml");
  NodeWatcher other(scene["bodies"][0]["name"].as<std::string>());
  pick("scene", "regimes");
  ASSERT_TRUE(until([&] {
    other.hear();
    return other.states > 0;
  }));
  EXPECT_EQ(other.state.time_rate, 1);
  ASSERT_TRUE(until([&] { return combo("body")->count() == static_cast<int>(scene["bodies"].size()); }));
  EXPECT_TRUE(until([] { return find<QLabel>("energy")->text().contains("J"); }));
  // The overview shows all of the new scene, from no farther than it must.
  rviz::VisualizationManager* const manager = shown->frame().getManager();
  const QWidget* const picture = manager->getRenderPanel();
  double farthest = 0;
  for (const auto& body : scene["bodies"]) {
    if (body["effects"]) farthest = std::max(farthest, std::abs(body["effects"][0]["position"][1].as<double>()));
  }
  const auto half_width = [&] {
    return manager->getViewManager()->getCurrent()->subProp("Distance")->getValue().toDouble() * std::tan(M_PI / 8) *
           picture->width() / picture->height();
  };
  EXPECT_TRUE(until([&] { return half_width() > farthest + 0.9 && half_width() < 2 * (farthest + 0.9); }))
      << half_width() << " m, with bodies up to " << farthest << " m from the middle";
  // And the floor lies below it.
  rviz::Property* const floor = manager->getRootDisplayGroup()->getDisplayAt(0);
  ASSERT_EQ(floor->getName(), "Floor");
  EXPECT_LT(floor->subProp("Offset")->subProp("Z")->getValue().toDouble(), -3);
  // A step belongs to the new scene's body; the other body can be looked at.
  pick("body", combo("body")->itemText(1));
  EXPECT_TRUE(until([] { return find<QLabel>("energy")->text().contains("J"); }));
}

TEST_F(Panel, saysWhatTheBodyDoesAndWhatTheSceneShows) {
  EXPECT_TRUE(until([] { return find<QLabel>("regime")->text().startsWith("turns over; Ω circles the axis of "); }))
      << find<QLabel>("regime")->text().toStdString();
  EXPECT_TRUE(until([] { return find<QLabel>("scene_words")->text().contains("turns over every 5.1 s"); }));
  EXPECT_TRUE(find<QLabel>("method_words")->text().startsWith("exact"));
  QTest::mouseClick(combo("scene"), Qt::LeftButton);
  spin(1);
  shown->picture("panel_scenes");
  QTest::keyClick(combo("scene")->view(), Qt::Key_Escape);
  QTest::mouseClick(combo("method"), Qt::LeftButton);
  spin(1);
  shown->picture("panel_methods");
  QTest::keyClick(combo("method")->view(), Qt::Key_Escape);
}

TEST_F(Panel, theTourLeadsFromCardToCard) {
  const auto isOn = [](int card) {
    return until([&] { return find<QLabel>("tour_title")->text().startsWith(QString("%1 of 8").arg(card)); });
  };
  press<QToolButton>("tour");
  ASSERT_TRUE(isOn(1));
  EXPECT_FALSE(find<QPushButton>("tour_back")->isEnabled());
  press<QPushButton>("tour_next");
  ASSERT_TRUE(isOn(2));
  EXPECT_TRUE(untilState([](const auto& state) { return state.time >= 6.5 && state.time_rate == 0.25; }));
  spin(1);
  shown->picture("panel_tour");
  press<QPushButton>("tour_next");
  ASSERT_TRUE(isOn(3));
  EXPECT_TRUE(until([] {
    for (const auto* view : shown->frame().findChildren<QPushButton*>()) {
      if (view->text() == "Along L" && view->isChecked()) return true;
    }
    return false;
  })) << "not seen along L";
  press<QPushButton>("tour_next");
  ASSERT_TRUE(isOn(4));
  EXPECT_TRUE(until([] { return combo("scene")->currentText() == "regimes"; }));
  press<QPushButton>("tour_back");
  ASSERT_TRUE(isOn(3));
  // The node does not answer: the tour stays where it is, and goes on when the node is back.
  node->freeze();
  press<QPushButton>("tour_next");
  ASSERT_TRUE(until([] { return find<QLabel>("banner")->isVisible(); }));
  EXPECT_TRUE(find<QLabel>("tour_title")->text().startsWith("3 of 8"));
  node->thaw();
  ASSERT_TRUE(until([] { return controls()->isEnabled() && combo("scene")->currentText() == "regimes"; }));
  EXPECT_TRUE(find<QLabel>("tour_title")->text().startsWith("3 of 8"));
  for (int card = 4; card <= 8; ++card) {
    press<QPushButton>("tour_next");
    ASSERT_TRUE(isOn(card));
  }
  EXPECT_FALSE(find<QPushButton>("tour_next")->isEnabled());
  EXPECT_TRUE(until([] { return heard->description.method == "lie_euler" && heard->description.step == 1.0 / 60; }));
  EXPECT_TRUE(untilState([](const auto& state) { return state.time_rate == 1; }));
  press<QToolButton>("tour");
  EXPECT_FALSE(find<QWidget>("tour_box")->isVisible());
}

TEST_F(Panel, torquesAreCalledByTheirName) {
  pick("scene", "damped_tumble");
  EXPECT_TRUE(until([] { return find<QLabel>("attitude_error")->text() == "no closed form under torque"; }));
  EXPECT_FALSE(find<QLabel>("flips")->text().contains("nan", Qt::CaseInsensitive));
  EXPECT_TRUE(find<QLabel>("error_legend")->text().startsWith("change of"));
  spin(2);
  shown->picture("panel_torque");
}

TEST_F(Panel, theNodeLearnsWhereTheEyeIs) {
  rviz::ViewManager* const views = shown->frame().getManager()->getViewManager();
  heard->forget();
  views->getCurrent()->subProp("Target Frame")->setValue("<Fixed Frame>");
  for (const char* angle : {"Yaw", "Pitch"}) views->getCurrent()->subProp(angle)->setValue(0);
  for (const char* axis : {"X", "Y", "Z"}) views->getCurrent()->subProp("Focal Point")->subProp(axis)->setValue(0);
  for (const double distance : {7.0, 3.0}) {
    views->getCurrent()->subProp("Distance")->setValue(distance);
    EXPECT_TRUE(until([&] {
      const auto& eye = heard->viewpoint;
      return heard->viewpoints > 0 && std::abs(eye.point.x - distance) < 1e-4 && std::abs(eye.point.y) < 1e-4 &&
             std::abs(eye.point.z) < 1e-4 && eye.header.frame_id == "world";
    })) << heard->viewpoint;
  }
  spin(0.5);
  heard->forget();
  spin(1);
  EXPECT_EQ(heard->viewpoints, 0) << "nothing is sent while the camera rests";
  // A view that is saved gets a button, which leads back there.
  const int before = views->getNumViews();
  views->copyCurrentToList();
  const QString button = QString("view_%1").arg(before);
  ASSERT_TRUE(until([&] { return shown->frame().findChild<QPushButton*>(button) != nullptr; }));
  views->getCurrent()->subProp("Distance")->setValue(9.0);
  ASSERT_TRUE(until([] { return std::abs(heard->viewpoint.point.x - 9) < 1e-4; }));
  press<QPushButton>(button);
  EXPECT_TRUE(until([] { return std::abs(heard->viewpoint.point.x - 3) < 1e-4; })) << heard->viewpoint;
}

TEST_F(Panel, ridingLeavesOutAllButThePictureInWorldAxes) {
  rviz::DisplayGroup* const displays = shown->frame().getManager()->getRootDisplayGroup();
  const auto display = [&](const QString& name) {
    for (int i = 0; i < displays->numDisplays(); ++i) {
      if (displays->getDisplayAt(i)->getName() == name) return displays->getDisplayAt(i);
    }
    return static_cast<rviz::Display*>(nullptr);
  };
  const auto listed = [&](const QString& ns, bool enabled) {
    const rviz::Property* const found = Panel::listed(display("Still"), ns);
    return found && found->getValue().toBool() == enabled;
  };
  ASSERT_TRUE(until([&] { return listed("wingnut/shape", true); }));
  const QString name = find<QPushButton>("view_1")->text();
  press<QPushButton>("view_1");
  EXPECT_TRUE(until([&] { return listed("wingnut/shape", false) && listed("wingnut/space/polhode", true); }));
  EXPECT_FALSE(display("Floor")->isEnabled());
  EXPECT_TRUE(display("Still")->isEnabled());
  EXPECT_TRUE(find<QPushButton>("view_1")->isChecked());
  EXPECT_FALSE(find<QPushButton>("view_0")->isChecked());
  rviz::Config config;
  find<rviz::Panel>("poinsot_panel")->save(config);
  QString view;
  EXPECT_TRUE(config.mapGetString("View", &view));
  EXPECT_EQ(view, name);
  EXPECT_TRUE(config.mapGetChild("Hidden").mapGetChild(name).mapGetChild("Floor").isValid());

  press<QPushButton>("view_0");
  EXPECT_TRUE(until([&] { return listed("wingnut/shape", true); })) << "RViz was not sent it again";
  EXPECT_TRUE(display("Floor")->isEnabled());
  EXPECT_TRUE(find<QPushButton>("view_0")->isChecked());
}

TEST_F(Panel, aViewThatIsLeftShowsNothingThatTheUserHid) {
  rviz::DisplayGroup* const displays = shown->frame().getManager()->getRootDisplayGroup();
  rviz::Display *floor = displays->getDisplayAt(0), *still = displays->getDisplayAt(1);
  ASSERT_EQ(floor->getName() + still->getName(), "FloorStill");
  ASSERT_TRUE(until([&] { return listed(still, "wingnut/shape") && listed(still, "wingnut/label"); }));
  listed(still, "wingnut/shape")->setValue(false);
  floor->setEnabled(false);
  press<QPushButton>("view_1");
  ASSERT_TRUE(
      until([&] { return listed(still, "wingnut/label") && !listed(still, "wingnut/label")->getValue().toBool(); }));
  press<QPushButton>("view_0");
  ASSERT_TRUE(
      until([&] { return listed(still, "wingnut/label") && listed(still, "wingnut/label")->getValue().toBool(); }));
  EXPECT_FALSE(listed(still, "wingnut/shape")->getValue().toBool());
  EXPECT_FALSE(floor->isEnabled());
  floor->setEnabled(true);
  listed(still, "wingnut/shape")->setValue(true);
  press<QPushButton>("view_1");
  press<QPushButton>("view_0");
  EXPECT_TRUE(
      until([&] { return listed(still, "wingnut/shape") && listed(still, "wingnut/shape")->getValue().toBool(); }));
  EXPECT_TRUE(floor->isEnabled());
}

TEST_F(Panel, aViewThatWasSavedBringsBackWhatItLeftOut) {
  auto* const panel = find<rviz::Panel>("poinsot_panel");
  rviz::DisplayGroup* const displays = shown->frame().getManager()->getRootDisplayGroup();
  rviz::Display *floor = displays->getDisplayAt(0), *still = displays->getDisplayAt(1);
  ASSERT_EQ(floor->getName() + still->getName(), "FloorStill");
  for (const bool wanted : {true, false}) {
    press<QPushButton>("view_0");
    floor->setEnabled(wanted);
    press<QPushButton>("view_1");
    EXPECT_FALSE(floor->isEnabled());
    rviz::Config saved;
    panel->save(saved);
    // As RViz begins with it: the display as it was saved, then the panel.
    panel->load(saved);
    EXPECT_FALSE(floor->isEnabled());
    press<QPushButton>("view_0");
    EXPECT_EQ(floor->isEnabled(), wanted);
  }
  floor->setEnabled(true);
}

TEST_F(Panel, aViewLooksDownThePresentL) {
  rviz::ViewManager* const views = shown->frame().getManager()->getViewManager();
  // How much of L's direction is towards the eye.
  const auto towards_the_eye = [&] {
    const double pitch = views->getCurrent()->subProp("Pitch")->getValue().toDouble();
    const double yaw = views->getCurrent()->subProp("Yaw")->getValue().toDouble();
    const auto& l = heard->state.momentum_world;
    return (std::cos(pitch) * (std::cos(yaw) * l.x + std::sin(yaw) * l.y) + std::sin(pitch) * l.z) /
           std::sqrt(l.x * l.x + l.y * l.y + l.z * l.z);
  };
  const auto spin_to = [&](double x, double y, double z) {
    poinsot::SetSpin wanted;
    wanted.request.body = "wingnut";
    wanted.request.omega_body.x = x;
    wanted.request.omega_body.y = y;
    wanted.request.omega_body.z = z;
    EXPECT_TRUE(ros::service::call("/poinsot/set_spin", wanted));
    EXPECT_TRUE(wanted.response.success) << wanted.response.message;
    return untilState(
        [&](const auto& state) { return std::abs(state.omega_body.x - x) + std::abs(state.omega_body.y - y) < 0.5; });
  };
  const QString along = "view_2";
  ASSERT_EQ(find<QPushButton>(along)->text(), "Along L");
  press<QPushButton>(along);
  EXPECT_TRUE(until([&] { return towards_the_eye() > 0.99; }))
      << towards_the_eye();  // from above, where L is nearly upright
  ASSERT_TRUE(spin_to(2, -1, 1));
  EXPECT_TRUE(until([&] { return towards_the_eye() > 0.9999; })) << towards_the_eye();
  // A camera that the user has turned stays as it is until the view is chosen again.
  views->getCurrent()->subProp("Yaw")->setValue(1.0 + views->getCurrent()->subProp("Yaw")->getValue().toDouble());
  spin(1);
  EXPECT_LT(towards_the_eye(), 0.99);
  press<QPushButton>(along);
  EXPECT_TRUE(until([&] { return towards_the_eye() > 0.9999; })) << towards_the_eye();
  // Nor is one that was chosen in RViz's own list.
  views->setCurrentFrom(views->getViewAt(0));
  const double own = views->getCurrent()->subProp("Pitch")->getValue().toDouble();
  ASSERT_TRUE(spin_to(2, 1, -1));
  spin(0.5);
  EXPECT_EQ(views->getCurrent()->subProp("Pitch")->getValue().toDouble(), own);
  // The other view is not led.
  press<QPushButton>("view_0");
  const double pitch = views->getCurrent()->subProp("Pitch")->getValue().toDouble();
  ASSERT_TRUE(spin_to(-1, 2, -1));
  spin(0.5);
  EXPECT_EQ(views->getCurrent()->subProp("Pitch")->getValue().toDouble(), pitch);
}

TEST_F(Panel, whatRvizsOwnResetTakesAwayComesBack) {
  rviz::Display* const still = shown->frame().getManager()->getRootDisplayGroup()->getDisplayAt(1);
  ASSERT_EQ(still->getName(), "Still");
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(until([&] { return listed(still, "wingnut/shape") && listed(still, "wingnut/space/polhode"); }));
    spin(1);
    ASSERT_TRUE(QMetaObject::invokeMethod(&shown->frame(), "reset"));
    EXPECT_FALSE(listed(still, "wingnut/shape"));
  }
  // The body's mesh is loaded again, which RViz alone does not survive.
  EXPECT_TRUE(until([&] { return listed(still, "wingnut/shape") && listed(still, "wingnut/space/polhode"); }));
  spin(1);
}

TEST_F(Panel, theBackgroundIsLightOrDark) {
  auto* const colour = dynamic_cast<rviz::ColorProperty*>(
      shown->frame().getManager()->getRootDisplayGroup()->subProp("Global Options")->subProp("Background Color"));
  ASSERT_TRUE(colour);
  auto* const light = find<QCheckBox>("light_background");
  ASSERT_FALSE(light->isChecked());
  QTest::keyClick(light, Qt::Key_Space);
  EXPECT_EQ(colour->getColor(), QColor(236, 239, 244));
  QTest::keyClick(light, Qt::Key_Space);
  EXPECT_EQ(colour->getColor(), QColor(24, 28, 36));
  colour->setColor(QColor(255, 255, 255));
  EXPECT_TRUE(light->isChecked());
  colour->setColor(QColor(24, 28, 36));
}

TEST_F(Panel, theNodesNameIsASetting) {
  auto* const panel = find<rviz::Panel>("poinsot_panel");
  type("node", "/elsewhere");
  EXPECT_TRUE(until([] { return find<QLabel>("banner")->isVisible(); }));
  EXPECT_TRUE(find<QLabel>("banner")->text().contains("/elsewhere"));
  EXPECT_FALSE(controls()->isEnabled());
  rviz::Config config;
  panel->save(config);
  QString saved;
  ASSERT_TRUE(config.mapGetString("Node", &saved));
  EXPECT_EQ(saved, "/elsewhere");
  type("node", "no name");
  EXPECT_TRUE(until([] { return notice().contains("no name"); }));
  config.mapSetValue("Node", "/poinsot");
  panel->load(config);
  EXPECT_TRUE(until([] { return controls()->isEnabled(); }));
  EXPECT_EQ(find<QLineEdit>("node")->text(), "/poinsot");
  // A relative one is looked for in RViz's namespace, and saved as it was given.
  config.mapSetValue("Node", "poinsot");
  panel->load(config);
  panel->save(config);
  ASSERT_TRUE(config.mapGetString("Node", &saved));
  EXPECT_EQ(saved, "poinsot");
  EXPECT_TRUE(controls()->isEnabled()) << "it is the same node";
  EXPECT_TRUE(until([] { return find<QLabel>("energy")->text().contains("J"); })) << "its states are not heard";
}

TEST_F(Panel, aNodeThatDiesIsMissedAndOneThatComesBackIsFound) {
  for (int round = 0; round < 2; ++round) {
    ASSERT_TRUE(until([] { return find<QLabel>("energy")->text().contains("J"); }));
    node->kill();
    ASSERT_TRUE(until([] { return find<QLabel>("banner")->isVisible(); }));
    EXPECT_FALSE(controls()->isEnabled());
    EXPECT_TRUE(find<QLabel>("banner")->text().contains("/poinsot"));
    EXPECT_TRUE(find<QLabel>("banner")->text().contains("roslaunch poinsot demo.launch"));
    EXPECT_EQ(find<QLabel>("energy")->text(), "–");
    for (const char* name : {"play", "reset", "step"}) EXPECT_FALSE(find<QPushButton>(name)->isEnabled()) << name;
    spin(1);
    if (round == 0) shown->picture("panel_no_node");
    startNode();
    ASSERT_TRUE(until([] { return controls()->isEnabled() && !find<QLabel>("banner")->isVisible(); }));
    press<QPushButton>("play");
    ASSERT_TRUE(untilState([](const auto& state) { return state.time_rate == 0; }));
    press<QToolButton>("backwards");
    ASSERT_TRUE(until([] { return find<QPushButton>("play")->text().contains("Play"); }));
    press<QPushButton>("play");
    ASSERT_TRUE(untilState([](const auto& state) { return state.time_rate == -1; }));
  }
}

TEST_F(Panel, aRecordingIsReadOutWithoutANode) {
  node.reset();
  ASSERT_TRUE(until([] { return find<QLabel>("banner")->isVisible(); }));
  ros::NodeHandle handle;
  ros::Publisher player = handle.advertise<poinsot::BodyState>("/recorded/state", 100);
  poinsot::BodyState state;
  state.body = "recorded";
  state.kinetic_energy = 2;
  state.omega_body.z = 1;
  state.momentum_world.z = 4;
  const auto playsUntil = [&](const std::function<bool()>& condition) {
    return until([&] {
      state.time += 0.01;
      state.header.stamp = ros::Time::now();
      player.publish(state);
      return condition();
    });
  };
  ASSERT_TRUE(playsUntil([] { return combo("body")->findText("recorded") >= 0; }));
  pick("body", "recorded");
  EXPECT_TRUE(playsUntil([] { return find<QLabel>("banner")->text().contains("A recording"); }));
  EXPECT_TRUE(playsUntil([] { return find<QLabel>("energy")->text() == "2 J"; }));
  EXPECT_TRUE(find<QLabel>("energy")->isEnabled());
  EXPECT_FALSE(controls()->isEnabled());
  EXPECT_FALSE(combo("method")->isEnabled());
  EXPECT_TRUE(playsUntil([] { return notice() == "Showing a recording."; }));
  spin(3);
  EXPECT_TRUE(find<QLabel>("banner")->text().contains("A recording")) << "it is paused";
  EXPECT_EQ(find<QLabel>("energy")->text(), "2 J");
  shown->picture("panel_recording");
}

// A stopped node stays connected and answers nothing: were anything here to wait for it, this would not come back.
TEST_F(Panel, aNodeThatHangsDoesNotHangRviz) {
  node->freeze();
  press<QPushButton>("play");
  press<QPushButton>("reset");
  EXPECT_TRUE(until([] { return find<QLabel>("banner")->isVisible(); }));
  EXPECT_FALSE(controls()->isEnabled());
  node->thaw();
  EXPECT_TRUE(until([] { return controls()->isEnabled() && !find<QLabel>("banner")->isVisible(); }));
  ASSERT_TRUE(until([] { return heard->states > 0; }));
  spin(1);
  const bool paused = heard->state.time_rate == 0;
  press<QPushButton>("play");
  EXPECT_TRUE(untilState([&](const auto& state) { return (state.time_rate == 0) != paused; }));
}

TEST_F(Panel, zAMasterThatIsRestartedIsFoundAgain) {
  heard.reset();  // it would hear nothing any more, and keep others of this process from subscribing anew
  node->kill();
  master->kill();
  const auto lost = [] { return find<QLabel>("banner")->isVisible(); };
  ASSERT_TRUE(shown->spinUntil(lost, kPatience));
  shown->spin(5);
  startMaster();
  startNode();
  EXPECT_TRUE(shown->spinUntil([&] { return controls()->isEnabled() && !lost(); }, kPatience));
  heard = std::make_unique<NodeWatcher>("wingnut");
  ASSERT_TRUE(until([] { return heard->states > 0; }));
  press<QPushButton>("play");
  EXPECT_TRUE(untilState([](const auto& state) { return state.time_rate == 0; }));
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (argc < 2) {
    std::cerr << "usage: test_panel PANEL.rviz\n";
    return 2;
  }
  view_file = argv[1];
  QApplication application(argc, argv);
  {
    QTcpServer server;
    server.listen(QHostAddress::LocalHost);
    qputenv("ROS_MASTER_URI", QString("http://127.0.0.1:%1").arg(server.serverPort()).toLatin1());
    qputenv("ROS_IP", "127.0.0.1");
    qunsetenv("ROS_HOSTNAME");
  }
  ros::init(argc, argv, "test_panel");
  startMaster();
  const ros::NodeHandle handle;  // waits for the master; nobody but RViz may call its callbacks: no spinner
  const int result = RUN_ALL_TESTS();
  master.reset();
  return result;
}
