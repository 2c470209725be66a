#pragma once

#include <poinsot/BodyDescription.h>
#include <poinsot/BodyState.h>

#include <Eigen/Core>
#include <QLabel>
#include <QWidget>
#include <array>

#include "history.h"

class QwtPlot;
class QwtPlotCurve;

namespace poinsot::rviz_panel {

/**
 * The last seconds of one body: Ω in principal axes, E/E₀, and on a log scale how far energy, momentum and attitude are
 * off.
 */
class Plots : public QWidget {
 public:
  Plots();

  void add(const BodyState& state);
  void setPrincipalAxes(const BodyDescription& description);
  void clear();
  /** Draws what is new; costs nothing where nothing is. */
  void refresh();

 private:
  /** Under torques there is no true error, and a change is no drift. */
  void showLegend(bool has_truth);
  void drawOmega(double from, double to);
  void drawEnergy(double from, double to);
  void drawErrors(double from, double to);

  History history_;
  Eigen::Matrix3d to_principal_ = Eigen::Matrix3d::Identity();
  bool changed_ = true;
  double omega_bound_ = 0;
  QwtPlot* omega_plot_;
  QwtPlot* energy_plot_;
  QwtPlot* error_plot_;
  QLabel* error_legend_;
  std::array<QwtPlotCurve*, 3> omega_curves_;
  std::array<QwtPlotCurve*, 1> energy_curves_;
  std::array<QwtPlotCurve*, 3> error_curves_;
  std::array<QwtPlotCurve*, 3> omega_tips_;
};

}  // namespace poinsot::rviz_panel
