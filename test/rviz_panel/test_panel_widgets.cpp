// Widgets of the panel by themselves: on no display, without RViz, without a node.
#include <gtest/gtest.h>
#include <qwt_interval.h>
#include <qwt_plot.h>

#include <QAbstractItemView>
#include <QApplication>
#include <QTest>
#include <QVBoxLayout>
#include <cmath>

#include "choice_list.h"
#include "node_link.h"
#include "plots.h"
#include "read_outs.h"
#include "time_control.h"
#include "widgets.h"

namespace {

using namespace poinsot::rviz_panel;

/** A window with a line that shows a t which goes on, and another widget that can have the focus. */
class TypedTime : public testing::Test {
 protected:
  TypedTime() {
    auto* const layout = new QVBoxLayout(&window_);
    layout->addWidget(labelOf(&edit_, "t&ime"));
    layout->addWidget(&edit_);
    layout->addWidget(&other_);
    window_.show();
    QApplication::setActiveWindow(&window_);
    other_.setFocus();
    arrive("12.35");
  }
  ~TypedTime() override {
    edit_.setParent(nullptr);
    other_.setParent(nullptr);
  }
  void arrive(const char* time) { showText(&edit_, time); }
  std::string text() const { return edit_.text().toStdString(); }

  LiveEdit edit_;
  QLineEdit other_;
  QWidget window_;
};

TEST_F(TypedTime, runsWhileNobodyTypes) {
  arrive("12.45");
  EXPECT_EQ(text(), "12.45");
}

TEST_F(TypedTime, aClickADoubleClickAndATripleClickSelectAllOfIt) {
  const QPoint middle(edit_.width() / 2, edit_.height() / 2);
  QTest::mouseClick(&edit_, Qt::LeftButton, {}, middle);
  EXPECT_EQ(edit_.selectedText(), "12.35");
  QTest::mouseDClick(&edit_, Qt::LeftButton, {}, middle);
  EXPECT_EQ(edit_.selectedText(), "12.35");
  QTest::mouseClick(&edit_, Qt::LeftButton, {}, middle);  // the third of a triple click
  EXPECT_EQ(edit_.selectedText(), "12.35");
  arrive("99.99");
  QTest::keyClicks(&edit_, "7");
  EXPECT_EQ(text(), "7");
}

TEST_F(TypedTime, itsKeyLeadsToItAndSelectsAllOfIt) {
  QTest::keyClick(&window_, Qt::Key_I, Qt::AltModifier);
  QApplication::processEvents();
  ASSERT_TRUE(edit_.hasFocus());
  EXPECT_EQ(edit_.selectedText(), "12.35");
  arrive("12.45");
  EXPECT_EQ(edit_.selectedText(), "12.35") << "it stands still, and is still selected";
  QTest::keyClicks(&edit_, "1e9");
  EXPECT_EQ(text(), "1e9");
}

TEST_F(TypedTime, whatIsTypedIsNotOverwritten) {
  edit_.setFocus(Qt::OtherFocusReason);  // as when the window comes to the front
  arrive("12.45");
  EXPECT_EQ(text(), "12.45");
  for (const char* digit : {"4", "2", ".", "5"}) {
    QTest::keyClicks(&edit_, digit);
    arrive("13.00");
  }
  EXPECT_EQ(text(), "42.5") << "the digits replace what was there, one after the other";
  QTest::keyClick(&edit_, Qt::Key_Left);
  arrive("13.10");
  QTest::keyClick(&edit_, Qt::Key_Backspace);
  arrive("13.20");
  EXPECT_EQ(text(), "425");
}

TEST_F(TypedTime, goesOnAfterEnterEscapeOrElsewhere) {
  const auto typed = [this] {
    edit_.setFocus();
    QTest::keyClicks(&edit_, "5");
    arrive("13.00");
    EXPECT_EQ(text(), "5");
  };
  typed();
  QTest::keyClick(&edit_, Qt::Key_Return);
  arrive("14.00");
  EXPECT_EQ(text(), "14.00");
  typed();
  QTest::keyClick(&edit_, Qt::Key_Escape);
  arrive("15.00");
  EXPECT_EQ(text(), "15.00");
  typed();
  other_.setFocus();
  arrive("16.00");
  EXPECT_EQ(text(), "16.00");
}

class TimeField : public testing::Test {
 protected:
  TimeField() : control_(&link_), edit_(control_.findChild<QLineEdit*>("time")) {
    control_.show();
    QApplication::setActiveWindow(&control_);
  }
  void state(double time, unsigned segment) {
    poinsot::BodyState message;
    message.time = time;
    message.segment = segment;
    control_.showState(message);
  }
  void type(const char* text) {
    edit_->setFocus();
    QTest::keyClicks(edit_, text);
    QTest::keyClick(edit_, Qt::Key_Return);
  }
  std::string text() const { return edit_->text().toStdString(); }

  NodeLink link_;
  TimeControl control_;
  QLineEdit* edit_;
};

TEST_F(TimeField, showsTheTimeThatWasAskedForUntilTheNodeIsThere) {
  state(3, 7);
  EXPECT_EQ(text(), "3.00");
  type("50");
  EXPECT_EQ(text(), "50.00");
  poinsot::NodeStatus status;
  status.segment = 7;
  status.time = 3.1;
  control_.showStatus(status);
  state(3.2, 7);
  EXPECT_EQ(text(), "50.00") << "the old time came through";
  state(50.1, 8);
  EXPECT_EQ(text(), "50.10");
  control_.showStatus(status);
  EXPECT_EQ(text(), "50.10") << "a message from before the jump, which came late";
  state(50.2, 8);
  EXPECT_EQ(text(), "50.20");
}

TEST_F(TimeField, isNotChangedByWhatIsNoTime) {
  state(3, 7);
  type("soon");
  state(3.1, 7);
  EXPECT_EQ(text(), "3.10");
}

TEST(Plots, showTheEnergyOnALinearScaleThatHasRoomForIt) {
  Plots plots;
  const auto* const plot = plots.findChild<QwtPlot*>("energy_plot");
  const auto shows = [&](double drift) {
    poinsot::BodyState state;
    state.header.stamp = ros::Time(1 + std::abs(drift));
    state.time = std::abs(drift);
    state.energy_drift = drift;
    plots.add(state);
    plots.refresh();
    return plot->axisInterval(QwtPlot::yLeft);
  };
  EXPECT_EQ(shows(1e-15), QwtInterval(0.99, 1.01)) << "a drift of rounding is none";
  EXPECT_EQ(shows(-0.03), QwtInterval(0.95, 1.01));
  EXPECT_EQ(shows(0.7), QwtInterval(0.95, 2));
  plots.clear();
  EXPECT_EQ(shows(0), QwtInterval(0.99, 1.01));
}

TEST(ReadOuts, showTheMotionThatWouldBeginWhileItsSpinIsDragged) {
  ReadOuts read_outs;
  const auto text = [&](const char* name) { return read_outs.findChild<QLabel*>(name)->text().toStdString(); };
  poinsot::NodeStatus status;
  status.bodies.resize(1);
  poinsot::BodyStatus& body = status.bodies[0];
  body.name = "wing";
  body.held_energy = 3;
  body.held_momentum = 4;
  poinsot::BodyState state;
  state.kinetic_energy = 1;
  state.momentum_world.x = 2;
  read_outs.showStatus(status, "wing");
  read_outs.showState(state);
  EXPECT_EQ(text("energy"), "3 J") << "not that of the body, which stands still meanwhile";
  EXPECT_EQ(text("momentum"), "4 N·m·s");
  EXPECT_EQ(text("energy_drift"), "if let go");
  body.held_energy = body.held_momentum = std::nan("");
  read_outs.showStatus(status, "wing");
  read_outs.showState(state);
  EXPECT_EQ(text("energy"), "1 J");
  EXPECT_EQ(text("momentum"), "2 N·m·s");
  EXPECT_EQ(text("energy_drift"), "drift 0");
}

TEST(ChoiceList, headingsCannotBeChosen) {
  QComboBox combo;
  showWords(&combo);
  showChoices(&combo, {{"one", {}, true}, {"a", "words"}, {"two", {}, true}, {"one", "more"}}, "one");
  EXPECT_EQ(combo.currentText(), "one");
  EXPECT_EQ(combo.currentIndex(), 3) << "not the heading of that name";
  combo.setFocus();
  QTest::keyClick(&combo, Qt::Key_Up);
  EXPECT_EQ(combo.currentText(), "a") << "the keys pass over a heading";
  QTest::keyClick(&combo, Qt::Key_Up);
  EXPECT_EQ(combo.currentText(), "a");
  EXPECT_GT(combo.view()->sizeHintForColumn(0), combo.fontMetrics().horizontalAdvance("a: words"))
      << "there is room for the words";
  showChoices(&combo, plainChoices({"b"}), "b");
  EXPECT_EQ(combo.count(), 1);
  EXPECT_EQ(combo.currentText(), "b");
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  qputenv("QT_QPA_PLATFORM", "offscreen");
  qputenv("ROS_MASTER_URI", "http://127.0.0.1:1");  // where nobody is
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}
