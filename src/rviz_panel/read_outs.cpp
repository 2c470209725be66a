#include "read_outs.h"

#include <cmath>

#include "colours.h"
#include "regime_text.h"
#include "status.h"
#include "text.h"

namespace poinsot::rviz_panel {
namespace {

constexpr int kFlips = 3;  // the row

QString dot(const QColor& colour) {
  return QString("<span style='color:%1'>●</span> ").arg(colour.name());
}

double norm(const geometry_msgs::Vector3& v) {
  return std::hypot(v.x, v.y, v.z);
}

}  // namespace

ReadOuts::ReadOuts() : grid_(makeLayout<QGridLayout>(this)) {
  grid_->setHorizontalSpacing(6);
  grid_->setVerticalSpacing(2);
  grid_->setColumnStretch(1, 1);
  grid_->setColumnStretch(2, 1);

  const QString drift = "Relative, since the segment began: since the last seek, reset or change of method.";
  energy_ = addRow(0, dot(colours::kEnergy) + "energy", "energy", "E = ½ ΩᵀMΩ, of rotation.");
  energy_drift_ = addValue(0, 2, "energy_drift", drift);
  momentum_ = addRow(1, dot(colours::kMomentum) + "momentum", "momentum", "|L|, the angular momentum.");
  momentum_drift_ = addValue(1, 2, "momentum_drift", drift);
  attitude_error_ = addRow(2, dot(colours::kAttitudeError) + "true error", "attitude_error",
                           "The angle between the attitude as published and the closed form at the same t.", 2);
  const QString flips = "How often the body turns over from t = 0 to now, by the closed form; negative before it.";
  flips_title_ = addTitle(kFlips, "flips", flips);
  flips_title_->setObjectName("flips_title");
  flips_ = addValue(kFlips, 1, "flips", flips);
  next_flip_ = addValue(kFlips, 2, "next_flip", "Simulated seconds to the next flip, in the direction of play.");
  cost_ = addRow(4, "cost", "cost", "CPU time that the motion takes per simulated second, measured.", 2);
  regime_title_ = addTitle(
      5, "regime",
      "Whether the body turns over or only wobbles, and which axis Ω circles on its polhode. A body that turns over "
      "circles one as well, from one end of the axis of intermediate moment to the other and back. Of the true "
      "motion.");
  regime_ = makeWords("regime", 1, 2);
  grid_->addWidget(regime_, 5, 1, 1, 2);
  clear();
}

QLabel* ReadOuts::addTitle(int row, const QString& text, const QString& tip) {
  auto* const title = new QLabel(text);
  title->setToolTip(tip);
  grid_->addWidget(title, row, 0);
  return title;
}

QLabel* ReadOuts::addValue(int row, int column, const QString& name, const QString& tip, int columns) {
  auto* const value = new QLabel;
  describe(value, name, tip);
  value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  value->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  grid_->addWidget(value, row, column, 1, columns);
  return value;
}

QLabel* ReadOuts::addRow(int row, const QString& title, const QString& name, const QString& tip, int columns) {
  addTitle(row, title, tip);
  return addValue(row, 1, name, tip, columns);
}

void ReadOuts::clear() {
  held_ = false;
  for (QLabel* label :
       {energy_, energy_drift_, momentum_, momentum_drift_, attitude_error_, flips_, next_flip_, cost_}) {
    label->setText(text::kUnknown);
  }
  regime_->setText(text::kUnknown);
}

void ReadOuts::showStatus(const NodeStatus& status, const QString& body) {
  const BodyStatus* const shown = bodyNamed(status, body);
  if (!shown) return;
  showHeld(*shown);
  regime_->setText(regimeText(*shown));
  const double to_next = shown->time_to_next_flip;
  const bool foreseen = !std::isnan(to_next);
  const bool counts = foreseen && shown->flips;
  if (counts) {
    flips_->setText(text::plain(static_cast<double>(shown->flips_since_start), 15));
    next_flip_->setText(std::isinf(to_next) ? QString("none to come") : "next in " + text::seconds(to_next));
  } else {
    flips_->setText(foreseen ? "it does not turn over" : "not foreseen under torque");
    next_flip_->clear();
  }
  grid_->addWidget(flips_, kFlips, 1, 1, counts ? 1 : 2);  // the words need more room than the figures
  // What a stepper makes of it may be another thing.
  const QString of_true_motion = foreseen && shown->method != "closed_form" ? "true " : "";
  flips_title_->setText(of_true_motion + "flips");
  regime_title_->setText(of_true_motion + "regime");
}

void ReadOuts::showHeld(const BodyStatus& body) {
  held_ = std::isfinite(body.held_energy);
  if (!held_) return;
  energy_->setText(text::withPrefix(body.held_energy, "J", 5));
  momentum_->setText(text::withPrefix(body.held_momentum, "N·m·s", 5));
  energy_drift_->setText("if let go");
  momentum_drift_->setText("if let go");
}

void ReadOuts::showState(const BodyState& state) {
  if (held_) return;
  energy_->setText(text::withPrefix(state.kinetic_energy, "J", 5));
  momentum_->setText(text::withPrefix(norm(state.momentum_world), "N·m·s", 5));
  const bool free = !std::isnan(state.attitude_error);
  const QString word = free ? "drift " : "Δ ";
  energy_drift_->setText(word + text::small(state.energy_drift));
  momentum_drift_->setText(word + text::small(state.momentum_drift));
  attitude_error_->setText(free ? text::small(state.attitude_error) + " rad" : "no closed form under torque");
  const double cost = state.cost;
  cost_->setText(std::isnan(cost) ? QString("not measured") : text::withPrefix(cost, "s") + " per simulated s");
}

}  // namespace poinsot::rviz_panel
