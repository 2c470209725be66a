#include "read_outs.h"

#include <QGridLayout>
#include <QLabel>
#include <cmath>

#include "colours.h"
#include "text.h"
#include "widgets.h"

namespace poinsot::rviz_panel {
namespace {

QString dot(const QColor& colour) {
  return QString("<span style='color:%1'>●</span> ").arg(colour.name());
}

QLabel* valueLabel(const QString& name, const QString& tip) {
  auto* const label = new QLabel("–");
  describe(label, name, tip);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  return label;
}

double norm(const geometry_msgs::Vector3& v) {
  return std::hypot(v.x, v.y, v.z);
}

void setText(QLabel* label, const QString& text) {
  if (label->text() != text) label->setText(text);
}

}  // namespace

ReadOuts::ReadOuts(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(6);
  grid_->setVerticalSpacing(2);
  grid_->setColumnStretch(1, 1);
  grid_->setColumnStretch(2, 1);

  const QString drift = "Relative, since the segment began: since the last seek, reset or change of method.";
  energy_ = addRow(dot(colours::kEnergy) + "energy", "energy", "E = ½ ΩᵀMΩ, of rotation.");
  energy_drift_ = valueLabel("energy_drift", drift);
  grid_->addWidget(energy_drift_, 0, 2);
  momentum_ = addRow(dot(colours::kMomentum) + "momentum", "momentum", "|L|, the angular momentum.");
  momentum_drift_ = valueLabel("momentum_drift", drift);
  grid_->addWidget(momentum_drift_, 1, 2);
  attitude_error_ = addRow(dot(colours::kAttitudeError) + "true error", "attitude_error",
                           "The angle between the attitude as published and the closed form at the same t.");
  flips_ = addRow("flips", "flips",
                  "How often the body turns over from t = 0 to now, by the closed form; negative before it.");
  flips_title_ = qobject_cast<QLabel*>(grid_->itemAtPosition(3, 0)->widget());
  flips_title_->setObjectName("flips_title");
  next_flip_ = valueLabel("next_flip", "Simulated seconds to the next flip, in the direction of play.");
  grid_->addWidget(next_flip_, 3, 2);
  cost_ = addRow("cost", "cost", "CPU time that the motion takes per simulated second, measured.");
  regime_title_ = new QLabel("regime");
  regime_title_->setToolTip(
      "What Ω goes round on its polhode: the axis of smallest moment, or that of largest. A body that flips goes round "
      "one of them as well, from one end of the axis between to the other and back. Of the true motion.");
  regime_ = new ElidedLabel;
  regime_->setObjectName("regime");
  grid_->addWidget(regime_title_, 5, 0);
  grid_->addWidget(regime_, 5, 1, 1, 2);
  for (QLabel* wide : {attitude_error_, cost_}) {
    grid_->addWidget(wide, wide == cost_ ? 4 : 2, 1, 1, 2);
  }
  clear();
}

QLabel* ReadOuts::addRow(const QString& title, const QString& name, const QString& tip) {
  const int row = grid_->rowCount() - (grid_->count() == 0 ? 1 : 0);
  auto* const label = new QLabel(title);
  label->setToolTip(tip);
  QLabel* const value = valueLabel(name, tip);
  grid_->addWidget(label, row, 0);
  grid_->addWidget(value, row, 1);
  return value;
}

void ReadOuts::clear() {
  for (QLabel* label :
       {energy_, energy_drift_, momentum_, momentum_drift_, attitude_error_, flips_, next_flip_, cost_}) {
    setText(label, "–");
  }
  regime_->setFullText("–");
}

void ReadOuts::showStatus(const NodeStatus& status, const QString& body) {
  for (const BodyStatus& shown : status.bodies) {
    if (QString::fromStdString(shown.name) != body) continue;
    regime_->setFullText(QString::fromStdString(shown.regime));
    bool in_one = true;  // the words need more room than the figures
    QString flips, next;
    // What a stepper makes of it may be another thing.
    const bool of_true_motion = !std::isnan(shown.time_to_next_flip) && shown.method != "closed_form";
    if (std::isnan(shown.time_to_next_flip)) {
      flips = "not foreseen under torque";
    } else if (!shown.flips) {
      flips = "it does not turn over";
    } else {
      in_one = false;
      flips = text::plain(static_cast<double>(shown.flips_since_start), 15);
      next = std::isinf(shown.time_to_next_flip) ? QString("none to come")
                                                 : "next in " + text::seconds(shown.time_to_next_flip);
    }
    setText(flips_title_, of_true_motion ? "true flips" : "flips");
    setText(regime_title_, of_true_motion ? "true regime" : "regime");
    setText(flips_, flips);
    setText(next_flip_, next);
    grid_->addWidget(flips_, 3, 1, 1, in_one ? 2 : 1);
    return;
  }
}

void ReadOuts::showState(const BodyState& state) {
  setText(energy_, text::withPrefix(state.kinetic_energy, "J", 5));
  setText(momentum_, text::withPrefix(norm(state.momentum_world), "N·m·s", 5));
  const bool free = !std::isnan(state.attitude_error);
  const QString word = free ? "drift " : "Δ ";
  setText(energy_drift_, word + text::small(state.energy_drift));
  setText(momentum_drift_, word + text::small(state.momentum_drift));
  setText(attitude_error_, free ? text::small(state.attitude_error) + " rad" : "no closed form under torque");
  setText(cost_,
          std::isnan(state.cost) ? QString("not measured") : text::withPrefix(state.cost, "s", 3) + " per simulated s");
}

}  // namespace poinsot::rviz_panel
