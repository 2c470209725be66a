// RViz itself, in this process, on whatever display there is: does it show what a file of rviz/ promises, and no error?
// Usage: test_rviz VIEW.rviz --gtest_filter=WithNode.* or WithoutNode.*
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <ros/topic.h>
#include <rviz/display_group.h>
#include <rviz/properties/status_list.h>
#include <rviz/render_panel.h>
#include <rviz/visualization_frame.h>
#include <rviz/visualization_manager.h>
#include <tf2_msgs/TFMessage.h>
#include <yaml-cpp/yaml.h>

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QScreen>
#include <QTemporaryDir>
#include <functional>
#include <iostream>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "picture.h"

namespace {

QString view_file;

// What must be in a picture: less than half of what the scenes give; a picture without a node has none of the colours.
constexpr double kLeastOrange = 0.007;
constexpr double kLeastBlue = 0.007;
constexpr double kLeastSeam = 0.00004;
constexpr double kMostOfOneColour = 0.93;
constexpr double kLeastChange = 0.005;  // in kBetweenPictures seconds
constexpr double kBetweenPictures = 1;

constexpr double kHeadStart = 3;  // s that the node has been running when RViz comes
constexpr double kPatience = 40;  // s, for a machine that is busy
constexpr double kSettling = 3;   // s

/** RViz's window, opened with a view as `rviz -d` does. One a process: Ogre does not like to be started twice. */
class Rviz {
 public:
  explicit Rviz(const QString& view) {
    frame_.setApp(qApp);
    frame_.setSplashPath("");
    frame_.initialize(view);
    frame_.show();
  }

  void load(const QString& view) { frame_.loadDisplayConfig(view); }

  void spin(double seconds) {
    spinUntil([] { return false; }, seconds);
  }

  /** Lets RViz work until the condition holds; true when it came to hold. */
  bool spinUntil(const std::function<bool()>& condition, double seconds) {
    QElapsedTimer timer;
    for (timer.start(); static_cast<double>(timer.elapsed()) < 1000 * seconds;) {
      QApplication::processEvents(QEventLoop::AllEvents, 20);
      if (condition()) return true;
    }
    return false;
  }

  /** Every status that is not OK, as "display / status: text". */
  std::vector<std::string> complaints() {
    std::vector<std::string> out;
    collect(frame_.getManager()->getRootDisplayGroup(), "", out);
    return out;
  }

  int displays() { return frame_.getManager()->getRootDisplayGroup()->numDisplays(); }

  /** The namespaces of markers that are there to be seen. */
  std::set<std::string> namespaces() {
    std::set<std::string> out;
    rviz::DisplayGroup* group = frame_.getManager()->getRootDisplayGroup();
    for (int i = 0; i < group->numDisplays(); ++i) {
      const rviz::Display* display = group->getDisplayAt(i);
      for (int k = 0; display->isEnabled() && k < display->numChildren(); ++k) {
        if (display->childAt(k)->getNameStd() == "Namespaces") collectChecked(display->childAt(k), out);
      }
    }
    return out;
  }

  QImage picture(const QString& name) {
    const QImage image = QApplication::primaryScreen()
                             ->grabWindow(frame_.getManager()->getRenderPanel()->winId())
                             .toImage()
                             .convertToFormat(QImage::Format_RGB32);
    QDir().mkpath(PICTURES);
    const QString file = QString(PICTURES) + "/rviz_" + name + ".png";
    EXPECT_TRUE(image.save(file)) << file.toStdString();
    std::cout << file.toStdString() << " (" << image.width() << " x " << image.height() << "): " << sharesOf(image)
              << "\n";
    return image;
  }

 private:
  static void collect(rviz::Property* property, const std::string& path, std::vector<std::string>& out) {
    const auto* status = dynamic_cast<rviz::StatusProperty*>(property);
    const bool is_list = dynamic_cast<rviz::StatusList*>(property) != nullptr;
    if (status && !is_list && status->getLevel() != rviz::StatusProperty::Ok) {
      out.push_back(path + property->getNameStd() + ": " + property->getValue().toString().toStdString());
    }
    // Neither the root's name nor a status list's, which repeats the worst level, says anything.
    const bool is_root = property->getParent() == nullptr;
    const std::string below = is_root || is_list ? path : path + property->getNameStd() + " / ";
    for (int i = 0; i < property->numChildren(); ++i) collect(property->childAt(i), below, out);
  }

  static void collectChecked(const rviz::Property* list, std::set<std::string>& out) {
    for (int i = 0; i < list->numChildren(); ++i) {
      if (list->childAt(i)->getValue().toBool()) out.insert(list->childAt(i)->getNameStd());
    }
  }

  rviz::VisualizationFrame frame_;
};

std::unique_ptr<Rviz> shown;

std::string listed(const std::vector<std::string>& lines) {
  std::string out;
  for (const std::string& line : lines) out += "\n  " + line;
  return out;
}

/** The file with one text replaced, as RViz would load it. */
QString broken(const QTemporaryDir& directory, const QString& what, const QString& by) {
  QFile in(view_file);
  EXPECT_TRUE(in.open(QIODevice::ReadOnly));
  QString text = in.readAll();
  EXPECT_TRUE(text.contains(what)) << what.toStdString();
  QFile out(directory.filePath("broken.rviz"));
  EXPECT_TRUE(out.open(QIODevice::WriteOnly));
  out.write(text.replace(what, by).toUtf8());
  return out.fileName();
}

/** The names of the bodies in the scene that the node was given, as a file or as a tree; empty where there is no node.
 */
std::vector<std::string> bodiesOfScene() {
  std::vector<std::string> out;
  std::string file;
  XmlRpc::XmlRpcValue tree;
  if (ros::param::get("/poinsot/scene_file", file)) {
    for (const YAML::Node& body : YAML::LoadFile(file)["bodies"]) out.push_back(body["name"].as<std::string>());
  } else if (ros::param::get("/poinsot/scene", tree)) {
    for (int i = 0; i < tree["bodies"].size(); ++i) out.push_back(tree["bodies"][i]["name"]);
  }
  return out;
}

std::vector<std::string> bodies;

/** What a scene's bodies, all of which turn, must show at least. */
std::set<std::string> wantedNamespaces() {
  std::set<std::string> out;
  for (const std::string& name : bodies) {
    for (const char* part : {"shape", "label", "axes"}) out.insert(name + "/" + part);
    for (const char* picture : {"space", "model"}) {
      for (const char* part : {"energy_ellipsoid", "momentum_ellipsoid", "polhode", "omega"}) {
        out.insert(name + "/" + picture + "/" + part);
      }
    }
    out.insert(name + "/space/angular_momentum");
  }
  return out;
}

std::vector<std::string> missingNamespaces() {
  std::vector<std::string> out;
  const std::set<std::string> there = shown->namespaces();
  for (const std::string& wanted : wantedNamespaces()) {
    if (there.count(wanted) == 0) out.push_back(wanted);
  }
  return out;
}

bool allThere() {
  return missingNamespaces().empty() && shown->complaints().empty();
}

QString viewName() {
  return QFileInfo(view_file).completeBaseName();
}

class WithNode : public testing::Test {
 protected:
  // A failure in here would leave the tests out, in the results too: they tell it instead.
  static void SetUpTestSuite() {
    if (!ros::topic::waitForMessage<tf2_msgs::TFMessage>("/tf", ros::Duration(kPatience))) {
      trouble = "no node: nothing on /tf";
      return;
    }
    bodies = bodiesOfScene();
    if (bodies.empty()) {
      trouble = "no scene on the parameter server";
      return;
    }
    ros::WallDuration(kHeadStart).sleep();
    shown = std::make_unique<Rviz>(view_file);
    shown->spinUntil(allThere, kPatience);
    shown->spin(kSettling);
  }
  static void TearDownTestSuite() { shown.reset(); }

  void SetUp() override { ASSERT_TRUE(shown) << trouble; }

 private:
  static std::string trouble;
};

std::string WithNode::trouble;

TEST_F(WithNode, noDisplayComplains) {
  EXPECT_GT(shown->displays(), 0);
  EXPECT_EQ(shown->complaints().size(), 0u) << listed(shown->complaints());
}

TEST_F(WithNode, allPartsOfThePicturesArrive) {
  std::cout << shown->namespaces().size() << " namespaces of markers\n";
  EXPECT_EQ(missingNamespaces().size(), 0u) << listed(missingNamespaces());
}

TEST_F(WithNode, theEllipsoidsAndTheLineWhereTheyMeetAreSeen) {
  const Shares shares = sharesOf(shown->picture(viewName()));
  EXPECT_GT(shares.orange, kLeastOrange);
  EXPECT_GT(shares.blue, kLeastBlue);
  EXPECT_GT(shares.seam, kLeastSeam);
  EXPECT_LT(shares.commonest, kMostOfOneColour);
  EXPECT_EQ(shares.cut, 0) << "an ellipsoid does not fit into RViz's window as the view lays it out";
}

TEST_F(WithNode, thePictureMoves) {
  const QImage before = shown->picture(viewName());
  shown->spin(kBetweenPictures);
  const double share = changed(before, shown->picture(viewName()));
  std::cout << 100 * share << " % of the pixels changed\n";
  EXPECT_GT(share, kLeastChange);
}

// The same checks must fail for a view that is wrong. These come last: they load other views.

TEST_F(WithNode, zAWrongFrameIsNoticed) {
  const QTemporaryDir directory;
  shown->load(broken(directory, "Fixed Frame: world", "Fixed Frame: nowhere"));
  EXPECT_TRUE(shown->spinUntil([] { return !shown->complaints().empty(); }, kPatience));
  shown->spin(kSettling);
  std::cout << "complaints:" << listed(shown->complaints()) << "\n";
  const Shares shares = sharesOf(shown->picture(viewName() + "_wrong_frame"));
  EXPECT_LT(shares.orange, kLeastOrange);
  EXPECT_LT(shares.blue, kLeastBlue);
}

TEST_F(WithNode, zAnUnknownDisplayIsNoticed) {
  const QTemporaryDir directory;
  shown->load(broken(directory, "Class: rviz/Grid", "Class: rviz/NoSuchDisplay"));
  EXPECT_TRUE(shown->spinUntil([] { return !shown->complaints().empty(); }, kPatience));
  std::cout << "complaints:" << listed(shown->complaints()) << "\n";
}

TEST_F(WithNode, zAWrongTopicIsNoticed) {
  const QTemporaryDir directory;
  shown->load(broken(directory, "Marker Topic: markers_static", "Marker Topic: markers_statik"));
  shown->spin(2 * kSettling);
  EXPECT_FALSE(missingNamespaces().empty());
  std::cout << "missing:" << listed(missingNamespaces()) << "\n";
  const Shares shares = sharesOf(shown->picture(viewName() + "_wrong_topic"));
  EXPECT_LT(shares.orange, kLeastOrange);
  EXPECT_LT(shares.blue, kLeastBlue);
  EXPECT_LT(shares.seam, kLeastSeam);
}

TEST(WithoutNode, nothingIsSeenAndRvizSaysSo) {
  shown = std::make_unique<Rviz>(view_file);
  shown->spin(3 * kSettling);
  std::cout << "complaints:" << listed(shown->complaints()) << "\n";
  EXPECT_FALSE(shown->complaints().empty());
  EXPECT_TRUE(shown->namespaces().empty());
  const Shares shares = sharesOf(shown->picture("alone"));
  EXPECT_LT(shares.orange, kLeastOrange / 10);
  EXPECT_LT(shares.blue, kLeastBlue / 10);
  EXPECT_LT(shares.seam, kLeastSeam / 10);
  EXPECT_GT(shares.commonest, kMostOfOneColour / 2);
  shown.reset();
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "test_rviz");
  if (argc < 2) {
    std::cerr << "usage: test_rviz VIEW.rviz\n";
    return 2;
  }
  view_file = argv[1];
  QApplication application(argc, argv);
  const ros::NodeHandle handle;  // nobody but RViz may call its callbacks, on this thread: no spinner
  return RUN_ALL_TESTS();
}
