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
constexpr int kHeight = 106;      // pixels of a plot
constexpr int kLowHeight = 74;    // of that of E/E₀
constexpr double kFloor = 1e-17;  // of the log scale; 0 is drawn there
constexpr double kLowestTop = 1e-11;
constexpr double kLeastChange = 0.01;  // of E/E₀ that the scale shows, up and down
constexpr double kNoChange = 1e-9;     // far less than a pixel: rounding is not to look like noise
constexpr double kRoom = 0.02;         // of the span shown
constexpr double kAxisWidth = 40;      // pixels, so that the plots lie one above the other

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

QwtPlot* makePlot(const QString& name, const QString& tip, int height, bool logarithmic = false) {
  auto* const plot = new QwtPlot;
  describe(plot, name, tip);
  plot->setFixedHeight(height);
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

/** The word stays as dark as any other, to be read; what is coloured is a square before it. */
QString marked(const QString& word, const QColor& colour) {
  return QString("<span style='color:%1'>■</span>&nbsp;%2").arg(colour.name(), word);
}

/** Draws the points of each curve, over times `from` to `to`, and just the ticks of the scale. */
template <std::size_t n>
void draw(QwtPlot* plot, const std::array<QwtPlotCurve*, n>& curves, const std::array<QPolygonF, n>& points,
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
      makePlot("omega_plot", "The angular velocity of the body in its principal axes, over simulation time.", kHeight);
  energy_plot_ =
      makePlot("energy_plot", "E/E₀, over simulation time; E₀ is the energy when the segment began.", kLowHeight);
  error_plot_ =
      makePlot("error_plot",
               "How far energy and momentum have drifted since the segment began, and how far the attitude is "
               "from the closed form, over simulation time.",
               kHeight, true);
  const std::array<QColor, 3> omega_colours = {colours::kAxis1, colours::kAxis2, colours::kAxis3};
  const std::array<QColor, 3> error_colours = {colours::kEnergy, colours::kMomentum, colours::kAttitudeError};
  for (int i = 0; i < 3; ++i) {
    omega_curves_[i] = makeCurve(omega_plot_, omega_colours[i], 1.5);
    omega_tips_[i] = makeCurve(omega_plot_, omega_colours[i], 0);
    omega_tips_[i]->setStyle(QwtPlotCurve::NoCurve);
    omega_tips_[i]->setSymbol(new QwtSymbol(QwtSymbol::Ellipse, omega_colours[i], QPen(Qt::NoPen), QSize(6, 6)));
    error_curves_[i] = makeCurve(error_plot_, error_colours[i], 1.5);
  }
  energy_curves_[0] = makeCurve(energy_plot_, colours::kEnergy, 1.5);
  layout->addWidget(makeLegend(marked("Ω₁", omega_colours[0]) + " " + marked("Ω₂", omega_colours[1]) + " " +
                               marked("Ω₃", omega_colours[2]) + " in rad/s, principal axes, over t in s"));
  layout->addWidget(omega_plot_);
  layout->addSpacing(4);
  layout->addWidget(makeLegend(marked("E/E₀", colours::kEnergy)));
  layout->addWidget(energy_plot_);
  layout->addSpacing(4);
  error_legend_ = makeLegend({});
  error_legend_->setObjectName("error_legend");
  showLegend(true);
  layout->addWidget(error_legend_);
  layout->addWidget(error_plot_);
  refresh();
}

void Plots::showLegend(bool has_truth) {
  const QString both = marked("energy", colours::kEnergy) + ", " + marked("momentum", colours::kMomentum);
  error_legend_->setText(has_truth
                             ? "drift of " + both + "; " + marked("true error", colours::kAttitudeError) + " in rad"
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
  drawEnergy(from, to);
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

void Plots::drawEnergy(double from, double to) {
  std::array<QPolygonF, 1> points;
  double low = kLeastChange, high = kLeastChange;  // below and above 1
  for (std::size_t k = 0; k < history_.size(); ++k) {
    const double change = history_[k].energy_drift;
    if (!std::isfinite(change)) continue;
    points[0] << QPointF(history_[k].time, std::abs(change) < kNoChange ? 1 : 1 + change);
    low = std::max(low, -change);
    high = std::max(high, change);
  }
  const double bottom = 1 - std::min(1.0, roundUp(low)), top = 1 + roundUp(high);
  draw(energy_plot_, energy_curves_, points, from, to, QwtScaleDiv(bottom, top, {}, {}, {bottom, 1, top}));
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
