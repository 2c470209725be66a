#include "plots.h"

#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_engine.h>
#include <qwt_scale_widget.h>
#include <qwt_symbol.h>

#include <Eigen/Geometry>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "colours.h"
#include "text.h"
#include "widgets.h"

namespace poinsot::rviz_panel {
namespace {

constexpr double kWindow = 20;    // s of stamps
constexpr int kCapacity = 4000;   // samples
constexpr int kHeight = 116;      // pixels of each plot
constexpr double kFloor = 1e-17;  // of the log scale; 0 is drawn there
constexpr double kLowestTop = 1e-11;
constexpr double kRoom = 0.02;     // of the span shown
constexpr double kAxisWidth = 40;  // pixels, so that both plots lie one above the other

/** Ticks with true minus signs and powers of ten; a time far from 0 in full. */
class Ticks : public QwtScaleDraw {
 public:
  explicit Ticks(bool logarithmic) : logarithmic_(logarithmic) {}
  QwtText label(double value) const override {
    if (logarithmic_) return QwtText(QString("1e%1").arg(std::lround(std::log10(value))).replace('-', QChar(0x2212)));
    return QwtText(text::plain(std::abs(value) < 1e-12 * scaleDiv().range() ? 0 : value, 12));
  }

 private:
  bool logarithmic_;
};

QwtPlot* makePlot(const QString& name, const QString& tip, bool logarithmic) {
  auto* const plot = new QwtPlot;
  describe(plot, name, tip);
  plot->setFixedHeight(kHeight);
  plot->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  plot->setAutoReplot(false);
  plot->setCanvasBackground(colours::kPaper);
  auto* const canvas = qobject_cast<QwtPlotCanvas*>(plot->canvas());
  canvas->setFrameStyle(QFrame::NoFrame);
  plot->plotLayout()->setAlignCanvasToScales(true);
  plot->plotLayout()->setCanvasMargin(2);
  setLetters(plot, 0.8);
  for (const int axis : {QwtPlot::xBottom, QwtPlot::yLeft}) {
    auto* const ticks = new Ticks(logarithmic && axis == QwtPlot::yLeft);
    ticks->enableComponent(QwtAbstractScaleDraw::Backbone, false);
    ticks->setTickLength(QwtScaleDiv::MajorTick, 3);
    ticks->setTickLength(QwtScaleDiv::MediumTick, 0);
    ticks->setTickLength(QwtScaleDiv::MinorTick, 0);
    if (axis == QwtPlot::yLeft) ticks->setMinimumExtent(kAxisWidth);
    plot->setAxisScaleDraw(axis, ticks);
    plot->setAxisFont(axis, plot->font());
    plot->axisWidget(axis)->setMargin(0);
  }
  if (logarithmic) plot->setAxisScaleEngine(QwtPlot::yLeft, new QwtLogScaleEngine);
  plot->setAxisMaxMajor(QwtPlot::xBottom, 4);
  auto* const grid = new QwtPlotGrid;
  grid->setMajorPen(colours::kGrid, 1);
  grid->attach(plot);
  return plot;
}

QwtPlotCurve* makeCurve(QwtPlot* plot, const QColor& colour, double width) {
  auto* const curve = new QwtPlotCurve;
  curve->setPen(colour, width);
  curve->setRenderHint(QwtPlotItem::RenderAntialiased);
  curve->attach(plot);
  return curve;
}

QLabel* makeLegend(const QString& text) {
  QLabel* const legend = makeLabel(text, 0.9);
  legend->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  return legend;
}

QString coloured(const QString& text, const QColor& colour) {
  return QString("<b><span style='color:%1'>%2</span></b>").arg(colour.name(), text);
}

/** Draws the points of each curve, over times `from` to `to`, and just the ticks of the scale. */
void draw(QwtPlot* plot, const std::array<QwtPlotCurve*, 3>& curves, const std::array<QPolygonF, 3>& points,
          double from, double to, const QwtScaleDiv& scale) {
  plot->setAxisScaleDiv(QwtPlot::yLeft, scale);
  plot->setAxisScale(QwtPlot::xBottom, from, to);
  const int columns = std::max(50, plot->canvas()->width());
  for (std::size_t i = 0; i < curves.size(); ++i) curves[i]->setSamples(thinned(points[i], columns));
  plot->replot();
}

/** The least of 1, 2, 5, 10, … times a power of ten that is no less than a positive value. */
double roundUp(double value) {
  const double decade = std::pow(10, std::floor(std::log10(value)));
  for (const double step : {1, 2, 5}) {
    if (value <= step * decade) return step * decade;
  }
  return 10 * decade;
}

}  // namespace

Plots::Plots() : history_(kWindow, kCapacity) {
  auto* const layout = makeLayout<QVBoxLayout>(this, 1);
  omega_plot_ =
      makePlot("omega_plot", "The angular velocity of the body in its principal axes, over simulation time.", false);
  error_plot_ =
      makePlot("error_plot",
               "How far energy and momentum have drifted since the segment began, and how far the attitude is "
               "from the closed form, over simulation time.",
               true);
  const std::array<QColor, 3> omega_colours = {colours::kOmega1, colours::kOmega2, colours::kOmega3};
  const std::array<QColor, 3> error_colours = {colours::kEnergy, colours::kMomentum, colours::kAttitudeError};
  for (int i = 0; i < 3; ++i) {
    omega_curves_[i] = makeCurve(omega_plot_, omega_colours[i], 1.5);
    omega_tips_[i] = makeCurve(omega_plot_, omega_colours[i], 0);
    omega_tips_[i]->setStyle(QwtPlotCurve::NoCurve);
    omega_tips_[i]->setSymbol(new QwtSymbol(QwtSymbol::Ellipse, omega_colours[i], QPen(Qt::NoPen), QSize(6, 6)));
    error_curves_[i] = makeCurve(error_plot_, error_colours[i], 1.5);
  }
  layout->addWidget(makeLegend(coloured("Ω₁", omega_colours[0]) + " " + coloured("Ω₂", omega_colours[1]) + " " +
                               coloured("Ω₃", omega_colours[2]) + " in rad/s, principal axes, over t in s"));
  layout->addWidget(omega_plot_);
  layout->addSpacing(4);
  error_legend_ = makeLegend({});
  error_legend_->setObjectName("error_legend");
  showLegend(true);
  layout->addWidget(error_legend_);
  layout->addWidget(error_plot_);
  refresh();
}

void Plots::showLegend(bool has_truth) {
  const QString both = coloured("energy", colours::kEnergy) + ", " + coloured("momentum", colours::kMomentum);
  error_legend_->setText(has_truth
                             ? "drift of " + both + "; " + coloured("true error", colours::kAttitudeError) + " in rad"
                             : "change of " + both + ", relative");
}

void Plots::add(const BodyState& state) {
  showLegend(!std::isnan(state.attitude_error));
  const bool begins = history_.empty() || history_.newest().segment != state.segment;
  if (begins) omega_bound_ = 0;
  changed_ = changed_ || begins || history_.newest().time != state.time;
  history_.add(state);
}

void Plots::setPrincipalAxes(const BodyDescription& description) {
  const geometry_msgs::Quaternion& q = description.principal_axes;
  to_principal_ = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix().transpose();
  changed_ = true;
}

void Plots::clear() {
  history_.clear();
  omega_bound_ = 0;
  changed_ = true;
}

void Plots::refresh() {
  if (!changed_) return;
  changed_ = false;
  double from = 0;
  double to = 0;
  if (!history_.empty()) {
    from = to = history_[0].time;
    for (std::size_t i = 0; i < history_.size(); ++i) {
      from = std::min(from, history_[i].time);
      to = std::max(to, history_[i].time);
    }
  }
  // A young history begins with room for what is to come.
  const double least = 1e-9 * std::max({1.0, std::abs(from), std::abs(to)});
  if (to - from < least) to = from + std::max(least, 1.0);
  const double room = kRoom * (to - from);  // for the dots at the tips
  const bool backwards = history_.size() > 1 && history_.newest().time < history_[history_.size() - 2].time;
  (backwards ? from : to) += backwards ? -room : room;
  drawOmega(from, to);
  drawErrors(from, to);
}

void Plots::drawOmega(double from, double to) {
  std::array<QPolygonF, 3> points;
  double largest = 0;
  for (std::size_t k = 0; k < history_.size(); ++k) {
    const geometry_msgs::Vector3& body = history_[k].omega_body;
    const Eigen::Vector3d omega = to_principal_ * Eigen::Vector3d(body.x, body.y, body.z);
    largest = std::max(largest, omega.cwiseAbs().maxCoeff());
    for (int i = 0; i < 3; ++i) points[i] << QPointF(history_[k].time, omega[i]);
  }
  if (!(largest > 0) || !std::isfinite(largest)) largest = 1;
  const double bound = roundUp(1.02 * largest);
  if (bound > omega_bound_ || bound < omega_bound_ / 4) omega_bound_ = bound;
  for (int i = 0; i < 3; ++i) omega_tips_[i]->setSamples(points[i].mid(points[i].size() - 1));
  draw(omega_plot_, omega_curves_, points, from, to,
       QwtScaleDiv(-omega_bound_, omega_bound_, {}, {}, {-omega_bound_, 0, omega_bound_}));
}

void Plots::drawErrors(double from, double to) {
  std::array<QPolygonF, 3> points;
  double largest = kLowestTop;
  for (std::size_t k = 0; k < history_.size(); ++k) {
    const BodyState& state = history_[k];
    const std::array<double, 3> values = {state.energy_drift, state.momentum_drift, state.attitude_error};
    for (int i = 0; i < 3; ++i) {
      const double size = std::abs(values[i]);
      if (!std::isfinite(size)) continue;
      points[i] << QPointF(state.time, std::max(size, kFloor));
      largest = std::max(largest, size);
    }
  }
  // Whole threes of decades: the scale changes seldom.
  const int top = 3 * static_cast<int>(std::ceil((std::log10(largest) + 17) / 3)) - 17;
  QList<double> ticks;
  for (int decade = -17; decade <= top; decade += top > 1 ? 6 : 3) ticks << std::pow(10, decade);
  draw(error_plot_, error_curves_, points, from, to, QwtScaleDiv(kFloor / 2, 2 * std::pow(10, top), {}, {}, ticks));
}

}  // namespace poinsot::rviz_panel
