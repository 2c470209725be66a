#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QSlider>
#include <QString>
#include <QStringList>
#include <QWidget>

class QComboBox;

/** Small things that the parts of the panel share. */
namespace poinsot::rviz_panel {

/** Names a widget for tests and style sheets, and gives it a tooltip and what screen readers say. */
void describe(QWidget* widget, const QString& name, const QString& tip);

/** A slider whose handle jumps to where one clicks. */
class JumpSlider : public QSlider {
  Q_OBJECT

 public:
  explicit JumpSlider(QWidget* parent = nullptr);
};

/**
 * A line that shows what changes by itself, and can be typed over: from a click on it stays as it is, all of it
 * selected, until Enter, Escape or until it is left.
 */
class LiveEdit : public QLineEdit {
  Q_OBJECT

 public:
  explicit LiveEdit(QWidget* parent = nullptr);
  bool held() const { return held_; }

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void letGo();
  bool held_ = false;
};

/** A label that never asks for more room than there is: what does not fit is shown as "…", and in full as a tooltip. */
class ElidedLabel : public QLabel {
  Q_OBJECT

 public:
  explicit ElidedLabel(QWidget* parent = nullptr);
  void setFullText(const QString& text);
  QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void elide();
  QString full_;
};

/** Lets the wheel scroll the panel rather than change a widget that does not have the focus. */
void leaveWheelToPanel(QWidget* widget);

/** Shows these choices, the current one chosen, without a signal. Nothing happens while one of them is being picked. */
void showChoices(QComboBox* combo, const QStringList& choices, const QString& current);

/** Shows a text unless the user is at it. */
void showText(QLineEdit* edit, const QString& text);

}  // namespace poinsot::rviz_panel
