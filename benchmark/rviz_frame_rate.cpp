// Counts the pictures a second that RViz draws of a view, beside an RViz that shows nothing in a picture of the same
// size. Usage: rviz_frame_rate VIEW.rviz [--seconds S] [--rounds N] [--rate HZ] [--disable-anti-aliasing]
#include <OgreFrameListener.h>
#include <OgreRoot.h>
#include <ros/ros.h>
#include <rviz/display_group.h>
#include <rviz/ogre_helpers/render_system.h>
#include <rviz/properties/property.h>
#include <rviz/render_panel.h>
#include <rviz/visualization_frame.h>
#include <rviz/visualization_manager.h>

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

namespace {

constexpr double kSettling = 5;  // s, until all has arrived and been drawn once

/** An RViz without displays and panels. */
constexpr const char* kNothing = R"(Panels: []
Visualization Manager:
  Displays: []
  Global Options: {Background Color: 24; 28; 36, Fixed Frame: world, Frame Rate: 60}
  Tools: [{Class: rviz/Interact}]
  Views:
    Current: {Class: rviz/Orbit, Name: Current View}
Window Geometry: {Hide Left Dock: true, Hide Right Dock: true}
)";

class FrameCounter : public Ogre::FrameListener {
 public:
  bool frameEnded(const Ogre::FrameEvent&) override {
    ++count;
    return true;
  }
  int count = 0;
};

void spin(double seconds) {
  QElapsedTimer timer;
  for (timer.start(); timer.elapsed() < static_cast<qint64>(1000 * seconds);)
    QApplication::processEvents(QEventLoop::AllEvents, 20);
}

struct Pace {
  double frames_per_second;
  double cpu_a_frame;  // s, of all threads, those of the software OpenGL included
};

class Stage {
 public:
  explicit Stage(double rate) : rate_(rate) {}

  void open(const QString& view) {
    if (!opened_) {
      frame_.setApp(qApp);
      frame_.setSplashPath("");
      frame_.initialize(view);
      frame_.show();
      Ogre::Root::getSingleton().addFrameListener(&counter_);
      opened_ = true;
    } else {
      frame_.setWindowModified(false);  // else RViz asks whether to save
      frame_.loadDisplayConfig(view);
    }
    frame_.getManager()->getRootDisplayGroup()->subProp("Global Options")->subProp("Frame Rate")->setValue(rate_);
  }

  /** Sets the size of the picture, not of the window. */
  void fit(const QSize& size) {
    for (int i = 0; i < 3 && picture() != size; ++i) {
      frame_.resize(frame_.size() + size - picture());
      spin(1);
    }
  }
  QSize picture() { return frame_.getManager()->getRenderPanel()->size(); }

  Pace pace(double seconds) {
    spin(kSettling);
    counter_.count = 0;
    const std::clock_t cpu = std::clock();
    QElapsedTimer timer;
    timer.start();
    spin(seconds);
    return {1000.0 * counter_.count / static_cast<double>(timer.elapsed()),
            static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC / counter_.count};
  }

 private:
  double rate_;
  rviz::VisualizationFrame frame_;
  FrameCounter counter_;
  bool opened_ = false;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "rviz_frame_rate", ros::init_options::AnonymousName);
  CLI::App options("How many pictures a second RViz draws of a view, beside an RViz that shows nothing.");
  std::string view;
  double seconds = 10;
  int rounds = 3;
  double rate = 60;
  options.add_option("view", view, "a .rviz file")->required()->check(CLI::ExistingFile);
  options.add_option("--seconds", seconds, "of each measurement (10)")->check(CLI::PositiveNumber);
  options.add_option("--rounds", rounds, "of both, in turn (3)")->check(CLI::PositiveNumber);
  options.add_option("--rate", rate, "what RViz is asked for [Hz] (60); more shows what it can do")
      ->check(CLI::PositiveNumber);
  bool jagged = false;
  options.add_flag("--disable-anti-aliasing", jagged, "of both, as RViz's own option of that name does");
  CLI11_PARSE(options, argc, argv);

  if (jagged) rviz::RenderSystem::disableAntiAliasing();
  QApplication application(argc, argv);
  const QTemporaryDir directory;
  const QString nothing = directory.filePath("nothing.rviz");
  QFile file(nothing);
  if (!file.open(QIODevice::WriteOnly)) return 1;
  file.write(kNothing);
  file.close();

  Stage stage(rate);
  std::vector<double> ratios;
  for (int round = 1; round <= rounds; ++round) {
    stage.open(QString::fromStdString(view));
    spin(kSettling);
    const QSize size = stage.picture();
    const Pace shown = stage.pace(seconds);
    stage.open(nothing);
    spin(1);
    stage.fit(size);
    const Pace empty = stage.pace(seconds);
    ratios.push_back(shown.frames_per_second / empty.frames_per_second);
    std::printf(
        "round %d, %d x %d: %.1f frames/s of %.1f ms CPU each, an empty RViz (%d x %d) %.1f of %.1f ms, ratio %.2f\n",
        round, size.width(), size.height(), shown.frames_per_second, 1e3 * shown.cpu_a_frame, stage.picture().width(),
        stage.picture().height(), empty.frames_per_second, 1e3 * empty.cpu_a_frame, ratios.back());
    std::fflush(stdout);
  }
  std::printf("ratio, median of %d: %.2f\n", rounds, median(ratios));
  return 0;
}
