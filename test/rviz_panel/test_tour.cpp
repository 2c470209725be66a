// The tour: its cards, and the way from one to the next.
#include <gtest/gtest.h>
#include <rviz/yaml_config_reader.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "data_file.h"
#include "method_words.h"
#include "tour.h"

namespace {

using namespace poinsot::rviz_panel;
using Act = Tour::Act;

QVector<Card> cardsOfThePackage() {
  std::ifstream in(std::string(SOURCE_DIR) + "/panel/tour.yaml");
  return tourCards(QString::fromStdString(std::string(std::istreambuf_iterator<char>(in), {})));
}

std::set<std::string> savedViews(const QString& scene) {
  rviz::Config file;
  rviz::YamlConfigReader().readFile(file, QString(SOURCE_DIR) + "/rviz/" + scene + ".rviz");
  const rviz::Config saved = file.mapGetChild("Visualization Manager").mapGetChild("Views").mapGetChild("Saved");
  std::set<std::string> out;
  for (int i = 0; i < saved.listLength(); ++i) {
    QString name;
    saved.listChildAt(i).mapGetString("Name", &name);
    out.insert(name.toStdString());
  }
  return out;
}

TEST(TourCards, leadToScenesViewsAndMethodsThatThereAre) {
  const QVector<Card> cards = cardsOfThePackage();
  EXPECT_EQ(cards.size(), 8);
  for (const Card& card : cards) {
    const std::string title = card.title.toStdString();
    EXPECT_TRUE(std::filesystem::exists(std::string(SOURCE_DIR) + "/scenes/" + card.scene.toStdString() + ".yaml"))
        << title;
    EXPECT_EQ(savedViews("demo").count(card.view.toStdString()), 1u) << title;
    EXPECT_TRUE(card.method.isEmpty() || !wordsOfMethod(card.method).isEmpty()) << title;
  }
  EXPECT_EQ(cards.front().scene, "dzhanibekov");
  EXPECT_EQ(cards.back().method, "lie_euler");
  EXPECT_DOUBLE_EQ(cards.back().step, 1.0 / 60);
}

const char* const kGood = "title: a, says: b, scene: c, view: d, time: 1";

std::string refusalOf(const std::string& text) {
  try {
    tourCards(QString::fromStdString(text));
  } catch (const data_file::Error& error) {
    return error.what();
  }
  return "";
}

std::string refusalOfCard(const std::string& more) {
  return refusalOf("- {" + std::string(kGood) + ", " + more + "}");
}

TEST(TourCards, areRead) {
  const QVector<Card> cards =
      tourCards(QString("- {%1}\n- {%1, speed: -0.5, paused: true, method: {body: e, name: f}}").arg(kGood));
  ASSERT_EQ(cards.size(), 2);
  EXPECT_EQ(cards[0].time, 1);
  EXPECT_EQ(cards[0].speed, 1);
  EXPECT_FALSE(cards[0].paused);
  EXPECT_EQ(cards[0].method, "");
  EXPECT_EQ(cards[1].speed, -0.5);
  EXPECT_TRUE(cards[1].paused);
  EXPECT_EQ(cards[1].body + cards[1].method, "ef");
  EXPECT_EQ(cards[1].step, 0) << "chosen by the node";
}

TEST(TourCards, badOnesAreRefused) {
  EXPECT_EQ(refusalOf("a: b"), "panel/tour.yaml: expected a list of 1 to 50 entries, got something else");
  EXPECT_EQ(refusalOf("- {title: a}"),
            "panel/tour.yaml: card 1: expected a text of 1 to 200 letters under says, got none");
  EXPECT_EQ(refusalOf("- {title: a, says: b, scene: c, view: d}"),
            "panel/tour.yaml: card 1: expected a number under time, got none");
  EXPECT_EQ(refusalOf("- {title: a, says: " + std::string(201, 'x') + ", scene: c, view: d, time: 1}"),
            "panel/tour.yaml: card 1: expected a text of 1 to 200 letters under says, got one of 201");
  EXPECT_EQ(refusalOfCard("tiem: 1"),
            "panel/tour.yaml: card 1: expected one of method, paused, says, scene, speed, time, title, view, got tiem");
  EXPECT_EQ(refusalOfCard("speed: fast"), "panel/tour.yaml: card 1: expected a number up to 100 under speed, got fast");
  EXPECT_EQ(refusalOfCard("speed: nan"), "panel/tour.yaml: card 1: expected a number up to 100 under speed, got nan");
  EXPECT_EQ(refusalOfCard("speed: 0"), "panel/tour.yaml: card 1: expected a speed that is not 0, got 0");
  EXPECT_EQ(refusalOfCard("paused: 1"), "panel/tour.yaml: card 1: expected true or false under paused, got 1");
  EXPECT_EQ(refusalOfCard("method: {name: f}"),
            "panel/tour.yaml: card 1, method: expected a text of 1 to 80 letters under body, got none");
  EXPECT_EQ(refusalOfCard("method: {body: e, name: f, step: -1}"),
            "panel/tour.yaml: card 1, method: expected a step that is not negative, got -1");
}

class OnTour : public testing::Test {
 protected:
  OnTour()
      : tour(tourCards("- {title: one, says: b, scene: first, view: d, time: 1}\n"
                       "- {title: two, says: b, scene: second, view: d, time: 1, method: {body: e, name: rk4}}\n")) {
    status.scene = "first";
    status.segment = 3;
    tour.onStatus(status);
  }
  Act say(const std::string& scene, unsigned segment, bool busy = false) {
    status.scene = scene;
    status.segment = segment;
    status.activities.clear();
    if (busy) status.activities.emplace_back().kind = poinsot::Activity::LOAD_SCENE;
    return tour.onStatus(status);
  }
  void reachTheFirst() {
    ASSERT_EQ(tour.go(1), Act::load_scene);
    ASSERT_EQ(say("first", 4), Act::arrive);
    ASSERT_EQ(tour.shown(), 0);
  }

  Tour tour;
  poinsot::NodeStatus status;
};

TEST_F(OnTour, aCardIsReachedWhenItsSceneIsThere) {
  EXPECT_EQ(tour.shown(), -1);
  EXPECT_EQ(tour.go(1), Act::load_scene);
  EXPECT_EQ(tour.card().scene, "first");
  EXPECT_EQ(say("first", 3), Act::nothing) << "the scene of that name that played before";
  EXPECT_EQ(say("first", 3, true), Act::nothing);
  EXPECT_EQ(tour.shown(), -1);
  EXPECT_EQ(say("first", 4), Act::arrive);
  EXPECT_EQ(tour.shown(), 0);
  EXPECT_EQ(say("first", 5), Act::nothing) << "once";
}

TEST_F(OnTour, aMethodIsAskedForWhenTheSceneIsThere) {
  reachTheFirst();
  EXPECT_EQ(tour.go(1), Act::load_scene);
  EXPECT_EQ(say("second", 5), Act::set_method);
  EXPECT_EQ(say("second", 5), Act::nothing);
  status.bodies.resize(1);
  status.bodies[0].name = "e";
  status.bodies[0].method = "closed_form";
  EXPECT_EQ(say("second", 6), Act::nothing) << "a seek, but not yet the method";
  status.bodies[0].method = "rk4";
  EXPECT_EQ(tour.shown(), 0);
  EXPECT_EQ(say("second", 7), Act::arrive);
  EXPECT_EQ(tour.shown(), 1);
}

TEST_F(OnTour, aRefusalLeavesItOnItsCard) {
  reachTheFirst();
  tour.go(1);
  tour.fail();
  EXPECT_EQ(tour.shown(), 0);
  EXPECT_EQ(say("second", 5), Act::nothing) << "loaded by somebody else, later";
  tour.go(1);
  status.refused = "scene second refused";
  EXPECT_EQ(say("first", 5), Act::nothing);
  EXPECT_FALSE(tour.underWay());
  EXPECT_EQ(tour.shown(), 0);
  EXPECT_EQ(tour.go(1), Act::load_scene) << "it can be tried again";
  EXPECT_EQ(say("second", 6), Act::set_method) << "the refusal is an old one";
}

TEST(NextInAHurry, doesNotTakeTheTimeOfACardForTheSceneOfTheNext) {
  Tour tour(
      tourCards("- {title: one, says: b, scene: same, view: d, time: 6.5}\n"
                "- {title: two, says: b, scene: same, view: d, time: 6.5}\n"));
  const auto say = [&](unsigned segment, double time) {
    poinsot::NodeStatus status;
    status.scene = "same";
    status.segment = segment;
    status.time = time;
    return tour.onStatus(status);
  };
  say(3, 0);
  ASSERT_EQ(tour.go(1), Act::load_scene);
  ASSERT_EQ(say(4, 0.01), Act::arrive);
  EXPECT_EQ(tour.go(1), Act::load_scene) << "before the node is at 6.5 s";
  EXPECT_EQ(say(5, 6.51), Act::nothing) << "the time of the first card";
  EXPECT_EQ(tour.shown(), 0);
  EXPECT_EQ(say(6, 0.02), Act::arrive);
  EXPECT_EQ(tour.shown(), 1);
}

TEST(NextInAHurry, theNodeMayLoadAtOnceAndNeverSeek) {
  Tour tour(
      tourCards("- {title: one, says: b, scene: same, view: d, time: 6.5}\n"
                "- {title: two, says: b, scene: same, view: d, time: 6.5}\n"));
  poinsot::NodeStatus status;
  status.scene = "same";
  tour.onStatus(status);
  ASSERT_EQ(tour.go(1), Act::load_scene);
  status.segment = 1;
  ASSERT_EQ(tour.onStatus(status), Act::arrive);
  ASSERT_EQ(tour.go(1), Act::load_scene);
  status.segment = 2;
  status.time = 0.02;
  EXPECT_EQ(tour.onStatus(status), Act::arrive);
}

TEST_F(OnTour, hasTwoEnds) {
  EXPECT_FALSE(tour.canGo(-1));
  reachTheFirst();
  EXPECT_FALSE(tour.canGo(-1));
  EXPECT_TRUE(tour.canGo(1));
  EXPECT_EQ(tour.go(-1), Act::nothing);
  tour.go(1);
  EXPECT_FALSE(tour.canGo(1)) << "under way to the last";
  EXPECT_EQ(tour.go(-1), Act::load_scene);
  EXPECT_EQ(tour.card().scene, "first") << "turned round on the way";
}

}  // namespace
