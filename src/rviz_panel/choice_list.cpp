#include "choice_list.h"

#include <QAbstractItemView>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QStyledItemDelegate>

namespace poinsot::rviz_panel {
namespace {

constexpr int kWords = Qt::UserRole;
constexpr int kHeading = Qt::UserRole + 1;

class LineWithWords : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    const QString words = index.data(kWords).toString();
    if (!words.isEmpty()) option->text += ": " + words;
    if (!index.data(kHeading).toBool()) return;
    option->font.setBold(true);
    option->state |= QStyle::State_Enabled;  // as dark as the others: a title is to be read
  }
};

Choices choicesOf(const QComboBox& combo) {
  Choices out;
  for (int i = 0; i < combo.count(); ++i) {
    out.push_back({combo.itemText(i), combo.itemData(i, kWords).toString(), combo.itemData(i, kHeading).toBool()});
  }
  return out;
}

void add(QComboBox* combo, const Choice& choice) {
  combo->addItem(choice.name);
  const int i = combo->count() - 1;
  combo->setItemData(i, choice.words, kWords);
  combo->setItemData(i, choice.heading, kHeading);
  auto* const model = qobject_cast<QStandardItemModel*>(combo->model());
  if (choice.heading && model) model->item(i)->setFlags(Qt::NoItemFlags);
}

int placeOf(const QComboBox& combo, const QString& name) {
  for (int i = 0; i < combo.count(); ++i) {
    if (combo.itemText(i) == name && !combo.itemData(i, kHeading).toBool()) return i;
  }
  return -1;
}

}  // namespace

Choices plainChoices(const QStringList& names) {
  Choices out;
  for (const QString& name : names) out.push_back({name, {}});
  return out;
}

void showWords(QComboBox* combo) {
  combo->setItemDelegate(new LineWithWords(combo));
}

void showChoices(QComboBox* combo, const Choices& choices, const QString& current) {
  QAbstractItemView* const view = combo->view();
  if (view->isVisible()) return;
  const QSignalBlocker quiet(combo);
  if (choicesOf(*combo) != choices) {
    combo->clear();
    for (const Choice& choice : choices) add(combo, choice);
    view->setMinimumWidth(view->sizeHintForColumn(0) + view->verticalScrollBar()->sizeHint().width());
  }
  const int index = placeOf(*combo, current);
  if (index != combo->currentIndex()) combo->setCurrentIndex(index);
}

}  // namespace poinsot::rviz_panel
