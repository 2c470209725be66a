#pragma once

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSlider>
#include <QString>
#include <QWidget>
#include <cstddef>
#include <vector>

/** Widgets and functions that the parts of the panel share. */
namespace poinsot::rviz_panel {

/** Names a widget for tests and style sheets, and gives it a tooltip and what screen readers say. */
void describe(QWidget* widget, const QString& name, const QString& tip);

/** A layout without margins, of a widget or for another layout. */
template <typename Layout>
Layout* makeLayout(QWidget* of = nullptr, int spacing = 4) {
  auto* const layout = new Layout(of);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(spacing);
  return layout;
}

template <typename Button>
Button* makeButton(const QString& text, const QString& name, const QString& tip) {
  auto* const button = new Button;
  button->setText(text);
  describe(button, name, tip);
  return button;
}

/** Returns a label with letters `size` times as large as usual. */
QLabel* makeLabel(const QString& text, double size = 1, bool bold = false);

/** Returns a label for words that take as many lines as they need, at least so many. */
QLabel* makeWords(const QString& name, double size, int lines);

/** Returns a label whose underlined letter moves the focus to a widget. */
QLabel* labelOf(QWidget* widget, const QString& text);

/** Returns a list at least so many letters wide. */
QComboBox* makeList(const QString& name, const QString& tip, int letters);

/** Returns a slider from 0 to `last` whose handle jumps to where the user clicks. */
QSlider* makeSlider(const QString& name, const QString& tip, int last, int single_step, int page_step);

/** Returns widgets side by side, null for free space. The one at place `wide` takes the space that is left. */
QHBoxLayout* makeRow(const std::vector<QWidget*>& widgets, std::size_t wide = 1);

/** Makes the letters of a widget `size` times as large. */
void setLetters(QWidget* widget, double size, bool bold = false);

/**
 * A line that shows what changes by itself, and can be typed over. It stays as it is from a click, from when its key or
 * Tab leads to it (all of it is then selected) and from the first key that changes it (what is typed replaces all of
 * it), until Enter, Escape or until it is left. A double or triple click selects all of it.
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
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void hold();
  void letGo();
  bool held_ = false;
};

/** Shows a text unless the user is editing the line. */
void showText(QLineEdit* edit, const QString& text);

/** Shows a position without a signal. */
void showPosition(QSlider* slider, int position);

}  // namespace poinsot::rviz_panel
