#include "hosted_rviz.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QScreen>

HostedRviz::HostedRviz(const QString& view) {
  frame_.setApp(qApp);
  frame_.setSplashPath("");
  frame_.initialize(view);
  frame_.show();
  QApplication::setActiveWindow(&frame_);
}

bool HostedRviz::spinUntil(const std::function<bool()>& condition, double seconds) {
  QElapsedTimer timer;
  for (timer.start(); static_cast<double>(timer.elapsed()) < 1000 * seconds;) {
    QApplication::processEvents(QEventLoop::AllEvents, 20);
    if (condition()) return true;
  }
  return false;
}

void HostedRviz::spin(double seconds) {
  spinUntil([] { return false; }, seconds);
}

void HostedRviz::picture(const QString& name) {
  QDir().mkpath(PICTURES);
  QApplication::primaryScreen()->grabWindow(frame_.winId()).save(QString(PICTURES) + "/" + name + ".png");
}
