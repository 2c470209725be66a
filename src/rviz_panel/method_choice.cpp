#include "method_choice.h"

#include <QVBoxLayout>
#include <cmath>
#include <utility>

#include "choice_list.h"
#include "method_words.h"
#include "node_link.h"
#include "text.h"

namespace poinsot::rviz_panel {
namespace {

constexpr double kMilli = 1e-3;

}  // namespace

MethodChoice::MethodChoice(NodeLink* link) : link_(link) {
  method_ = makeList("method", "The method that moves this body: closed_form is exact, all others step and drift.", 8);
  showWords(method_);
  words_ = makeWords("method_words", 0.85, 1);
  step_label_ = new QLabel("step");
  step_ = new LiveEdit;
  describe(step_, "method_step",
           "The method's step in milliseconds; press Enter. Empty: the node chooses one that suits the motion.");
  step_->setPlaceholderText("chosen");
  step_->setAlignment(Qt::AlignRight);
  step_->setFixedWidth(step_->fontMetrics().horizontalAdvance("0.00123456"));
  auto* const layout = makeLayout<QVBoxLayout>(this, 2);
  layout->addLayout(makeRow({labelOf(method_, "&method"), method_, step_label_, step_, new QLabel("ms")}));
  layout->addWidget(words_);

  connect(method_, QOverload<int>::of(&QComboBox::activated), this, [this] { askMethod(0); });
  connect(step_, &QLineEdit::returnPressed, this, &MethodChoice::askStep);
}

void MethodChoice::askMethod(double step) {
  hold_off_.begin();
  step_->setModified(false);
  link_->setMethod(body_, method_->currentText(), step);
}

void MethodChoice::askStep() {
  const QString typed = step_->text().trimmed();
  step_->setModified(false);
  bool ok = true;
  const double milliseconds = typed.isEmpty() ? 0 : text::number(typed, &ok);
  if (!ok || !std::isfinite(milliseconds) || (!typed.isEmpty() && milliseconds <= 0)) {
    link_->refuse(QString("Expected a step of more than 0 milliseconds, or nothing, got “%1”.").arg(typed));
    return;
  }
  askMethod(milliseconds * kMilli);
}

void MethodChoice::showStatus(const NodeStatus& status, const QString& body) {
  if (body != std::exchange(body_, body)) {
    hold_off_.end();
    step_->setModified(false);
  }
  const BodyStatus* const shown = bodyNamed(status, body);
  method_->setEnabled(shown && shown->methods.size() > 1);
  const bool steps = shown && std::isfinite(shown->step);
  step_->setEnabled(steps);
  step_label_->setEnabled(steps);
  if (!shown || hold_off_.holds(isChanging(status))) return;
  QStringList names = text::list(shown->methods);
  const QString method = QString::fromStdString(shown->method);
  if (!names.contains(method)) names.prepend(method);
  Choices methods;
  for (const QString& name : names) methods.push_back({name, wordsOfMethod(name)});
  showChoices(method_, methods, method);
  words_->setText(wordsOfMethod(method));
  showText(step_, steps ? text::plain(shown->step / kMilli, 6) : QString());
}

}  // namespace poinsot::rviz_panel
