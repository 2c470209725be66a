#include "widgets.h"

#include <QEvent>
#include <QFont>
#include <QKeyEvent>
#include <QProxyStyle>
#include <QSignalBlocker>
#include <utility>

namespace poinsot::rviz_panel {
namespace {

class JumpStyle : public QProxyStyle {
 public:
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override {
    if (hint == SH_Slider_AbsoluteSetButtons) return Qt::LeftButton;
    return QProxyStyle::styleHint(hint, option, widget, data);
  }
};

class WheelGuard : public QObject {
 public:
  using QObject::QObject;
  bool eventFilter(QObject* object, QEvent* event) override {
    const auto* widget = qobject_cast<QWidget*>(object);
    if (event->type() != QEvent::Wheel || !widget || widget->hasFocus()) return false;
    event->ignore();
    return true;
  }
};

/** Lets the wheel scroll the panel rather than change a widget that does not have the focus. */
void leaveWheelToPanel(QWidget* widget) {
  widget->setFocusPolicy(Qt::StrongFocus);
  widget->installEventFilter(new WheelGuard(widget));
}

/** Whether a key moves the cursor in a line of text, or changes the text. */
bool changes(const QKeyEvent& event) {
  if (!event.text().isEmpty() && event.text().at(0).isPrint()) return true;
  for (const auto key : {QKeySequence::Paste, QKeySequence::SelectAll}) {
    if (event.matches(key)) return true;
  }
  switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Home:
    case Qt::Key_End:
    case Qt::Key_Backspace:
    case Qt::Key_Delete:
      return true;
    default:
      return false;
  }
}

}  // namespace

void describe(QWidget* widget, const QString& name, const QString& tip) {
  widget->setObjectName(name);
  widget->setToolTip(tip);
  widget->setAccessibleDescription(tip);
}

void setLetters(QWidget* widget, double size, bool bold) {
  QFont font = widget->font();
  font.setPointSizeF(size * font.pointSizeF());
  font.setBold(bold);
  widget->setFont(font);
}

QLabel* makeLabel(const QString& text, double size, bool bold) {
  auto* const label = new QLabel(text);
  setLetters(label, size, bold);
  return label;
}

QLabel* makeWords(const QString& name, double size, int lines) {
  QLabel* const label = makeLabel("", size);
  label->setObjectName(name);
  label->setWordWrap(true);
  QSizePolicy policy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  label->setSizePolicy(policy);
  label->setMinimumHeight(lines * label->fontMetrics().lineSpacing());
  return label;
}

QLabel* labelOf(QWidget* widget, const QString& text) {
  auto* const label = new QLabel(text);
  label->setBuddy(widget);
  return label;
}

QHBoxLayout* makeRow(const std::vector<QWidget*>& widgets, std::size_t wide) {
  auto* const row = makeLayout<QHBoxLayout>();
  for (std::size_t i = 0; i < widgets.size(); ++i) {
    if (widgets[i]) {
      row->addWidget(widgets[i], i == wide ? 1 : 0);
    } else {
      row->addStretch(1);
    }
  }
  return row;
}

QComboBox* makeList(const QString& name, const QString& tip, int letters) {
  auto* const list = new QComboBox;
  describe(list, name, tip);
  leaveWheelToPanel(list);
  list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  list->setMinimumContentsLength(letters);
  list->setMaxVisibleItems(30);
  return list;
}

QSlider* makeSlider(const QString& name, const QString& tip, int last, int single_step, int page_step) {
  auto* const slider = new QSlider(Qt::Horizontal);
  describe(slider, name, tip);
  auto* const style = new JumpStyle;
  style->setParent(slider);
  slider->setStyle(style);
  leaveWheelToPanel(slider);
  slider->setRange(0, last);
  slider->setSingleStep(single_step);
  slider->setPageStep(page_step);
  return slider;
}

LiveEdit::LiveEdit(QWidget* parent) : QLineEdit(parent) {
  connect(this, &QLineEdit::returnPressed, this, &LiveEdit::letGo);
}

void LiveEdit::hold() {
  if (std::exchange(held_, true)) return;
  selectAll();
}

void LiveEdit::letGo() {
  held_ = false;
  setModified(false);
  deselect();
}

void LiveEdit::mousePressEvent(QMouseEvent* event) {
  QLineEdit::mousePressEvent(event);
  hold();  // a second click is to a place in the text
}

void LiveEdit::mouseDoubleClickEvent(QMouseEvent* event) {
  QLineEdit::mouseDoubleClickEvent(event);  // from which Qt knows that a third click belongs to it
  hold();
  selectAll();  // and not the digits before or after the point
}

void LiveEdit::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    letGo();
    return;
  }
  if (changes(*event)) hold();
  QLineEdit::keyPressEvent(event);
}

void LiveEdit::focusInEvent(QFocusEvent* event) {
  QLineEdit::focusInEvent(event);
  const Qt::FocusReason reason = event->reason();
  if (reason == Qt::ShortcutFocusReason || reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason) hold();
}

void LiveEdit::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  if (event->reason() != Qt::PopupFocusReason) letGo();  // its own menu
}

void showText(QLineEdit* edit, const QString& text) {
  const auto* const live = qobject_cast<LiveEdit*>(edit);
  if (live && live->held()) return;
  if (edit->hasFocus() && edit->isModified()) return;
  if (edit->text() == text) return;
  edit->setText(text);  // which also clears "modified"
}

void showPosition(QSlider* slider, int position) {
  const QSignalBlocker quiet(slider);
  slider->setValue(position);
}

}  // namespace poinsot::rviz_panel
