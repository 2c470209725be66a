#pragma once

#include <rviz/visualization_frame.h>

#include <QString>
#include <functional>

/** RViz's window in this process, with a view opened as `rviz -d` does. One a process. */
class HostedRviz {
 public:
  explicit HostedRviz(const QString& view);

  rviz::VisualizationFrame& frame() { return frame_; }

  /** Lets RViz work until the condition holds; true when it came to hold. */
  bool spinUntil(const std::function<bool()>& condition, double seconds);
  void spin(double seconds);

  /** A widget of the window by its name; the process ends where there is none: no test could go on. */
  template <typename Widget>
  Widget* find(const QString& name) {
    auto* const widget = frame_.findChild<Widget*>(name);
    if (!widget) qFatal("no widget %s", qPrintable(name));
    return widget;
  }

  /** A picture of the whole window, kept with the results of the tests. */
  void picture(const QString& name);

 private:
  rviz::VisualizationFrame frame_;
};
