#include "method_choice.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <algorithm>
#include <cmath>

#include "status.h"
#include "text.h"
#include "widgets.h"

namespace poinsot::rviz_panel {
namespace {

constexpr double kMilli = 1e-3;

const BodyStatus* bodyNamed(const NodeStatus& status, const QString& name) {
  for (const BodyStatus& body : status.bodies) {
    if (QString::fromStdString(body.name) == name) return &body;
  }
  return nullptr;
}

}  // namespace

MethodChoice::MethodChoice(QWidget* parent) : QWidget(parent) {
  auto* const grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(4);
  auto* const body_label = new QLabel("bo&dy");
  body_ = new QComboBox;
  describe(body_, "body", "The body that is read out and plotted below, and whose method is chosen here.");
  body_label->setBuddy(body_);
  auto* const method_label = new QLabel("&method");
  method_ = new QComboBox;
  describe(method_, "method", "The method that moves this body: closed_form is exact, all others step and drift.");
  method_label->setBuddy(method_);
  step_label_ = new QLabel("step");
  step_ = new LiveEdit;
  describe(step_, "method_step",
           "The method's step in milliseconds; press Enter. Empty: the node chooses one that suits the motion.");
  step_->setPlaceholderText("chosen");
  step_->setAlignment(Qt::AlignRight);
  step_->setFixedWidth(step_->fontMetrics().horizontalAdvance("0.00123456"));
  for (QComboBox* combo : {body_, method_}) {
    leaveWheelToPanel(combo);
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    combo->setMinimumContentsLength(8);
    combo->setMaxVisibleItems(24);
  }
  grid->addWidget(body_label, 0, 0);
  grid->addWidget(body_, 0, 1, 1, 4);
  grid->addWidget(method_label, 1, 0);
  grid->addWidget(method_, 1, 1);
  grid->addWidget(step_label_, 1, 2);
  grid->addWidget(step_, 1, 3);
  grid->addWidget(new QLabel("ms"), 1, 4);
  grid->setColumnStretch(1, 1);

  connect(body_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    since_asked_.invalidate();
    step_->setModified(false);
    showStatus(NodeStatus(status_));
    Q_EMIT bodyChanged(body());
  });
  connect(method_, QOverload<int>::of(&QComboBox::activated), this, &MethodChoice::askMethod);
  connect(step_, &QLineEdit::returnPressed, this, &MethodChoice::askStep);
}

QString MethodChoice::body() const {
  return body_->currentText();
}

void MethodChoice::askMethod() {
  since_asked_.start();
  step_->setModified(false);
  Q_EMIT methodAsked(body(), method_->currentText(), 0);
}

void MethodChoice::askStep() {
  const QString typed = step_->text();
  step_->setModified(false);
  bool ok = true;
  const double milliseconds = typed.trimmed().isEmpty() ? 0 : text::number(typed, &ok);
  if (!ok || !std::isfinite(milliseconds) || (!typed.trimmed().isEmpty() && milliseconds <= 0)) {
    Q_EMIT refused(QString("Step “%1” refused: a positive number of milliseconds, or nothing, is allowed.").arg(typed));
    return;
  }
  since_asked_.start();
  Q_EMIT methodAsked(body(), method_->currentText(), milliseconds * kMilli);
}

void MethodChoice::showStatus(const NodeStatus& status) {
  status_ = status;
  QStringList bodies;
  for (const BodyStatus& body : status.bodies) bodies << QString::fromStdString(body.name);
  const QString before = body();
  showChoices(body_, bodies, bodies.contains(before) || bodies.isEmpty() ? before : bodies.front());
  if (body() != before) Q_EMIT bodyChanged(body());

  const BodyStatus* shown = bodyNamed(status, body());
  method_->setEnabled(shown && shown->methods.size() > 1);
  const bool steps = shown && std::isfinite(shown->step);
  step_->setEnabled(steps);
  step_label_->setEnabled(steps);
  if (!shown) return;
  if (since_asked_.isValid() && (!since_asked_.hasExpired(kHoldOff) || changing(status))) return;
  since_asked_.invalidate();
  QStringList methods;
  for (const std::string& method : shown->methods) methods << QString::fromStdString(method);
  const QString method = QString::fromStdString(shown->method);
  if (!methods.contains(method)) methods.prepend(method);
  showChoices(method_, methods, method);
  showText(step_, steps ? text::plain(shown->step / kMilli, 6) : QString());
}

}  // namespace poinsot::rviz_panel
