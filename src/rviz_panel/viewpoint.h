#pragma once

#include <QObject>
#include <QTimer>
#include <array>
#include <optional>

namespace rviz {
class VisualizationManager;
}

namespace poinsot::rviz_panel {

/** Watches where RViz's camera is, in the frame "world". */
class Viewpoint : public QObject {
  Q_OBJECT

 public:
  explicit Viewpoint(rviz::VisualizationManager* manager, QObject* parent = nullptr);

  /** Tells it again, although it may not have moved. */
  void repeat();

 Q_SIGNALS:
  /** The eye is elsewhere now [m]. */
  void moved(double x, double y, double z);

 private:
  void look();

  rviz::VisualizationManager* manager_;
  std::optional<std::array<double, 3>> told_;
  QTimer timer_;
};

}  // namespace poinsot::rviz_panel
