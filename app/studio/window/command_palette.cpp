// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/command_palette.h"

#include <QAction>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace mocapress {
namespace {

constexpr QSize kPaletteSize(560, 420);

bool hasAll(const QString& text, const QStringList& words) {
  return std::all_of(words.begin(), words.end(),
                     [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace

CommandPalette::CommandPalette(std::vector<Command> commands, QWidget* parent)
    : QDialog(parent),
      commands_(std::move(commands)),
      words_(new QLineEdit(this)),
      none_(new QLabel(tr("No command has these words."), this)),
      list_(new QTreeWidget(this)) {
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Find a Command"));
  resize(kPaletteSize);
  words_->setPlaceholderText(tr("Words of a command, such as: next note"));
  words_->setAccessibleName(tr("Words of a command"));
  words_->setClearButtonEnabled(true);
  words_->installEventFilter(this);
  list_->setAccessibleName(tr("Commands"));
  list_->setColumnCount(3);
  list_->setHeaderHidden(true);
  list_->setRootIsDecorated(false);
  list_->setFocusPolicy(Qt::NoFocus);
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  for (const int column : {1, 2})
    list_->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  auto* column = new QVBoxLayout(this);
  column->addWidget(words_);
  column->addWidget(none_);
  column->addWidget(list_, 1);
  connect(words_, &QLineEdit::textChanged, this, &CommandPalette::find);
  connect(words_, &QLineEdit::returnPressed, this, [this] { run(list_->currentItem()); });
  connect(list_, &QTreeWidget::itemClicked, this, &CommandPalette::run);
  find({});
}

/// Lists the commands that have all words: first those with the words in their own name, then those
/// with some of them in their menus' names.
void CommandPalette::find(const QString& text) {
  list_->clear();
  const QStringList words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  for (const bool in_name : {true, false})
    for (std::size_t i = 0; i < commands_.size(); ++i) {
      const Command& command = commands_[i];
      const QString name = plainText(command.action->text());
      const bool named = hasAll(name, words);
      const bool fits = in_name ? named : !named && hasAll(command.menus + name, words);
      if (!fits || !command.action->isVisible()) continue;
      auto* item = new QTreeWidgetItem(
          list_,
          {name, command.menus, command.action->shortcut().toString(QKeySequence::NativeText)});
      item->setData(0, Qt::UserRole, static_cast<int>(i));
      item->setDisabled(!command.action->isEnabled());
      item->setForeground(1, palette().color(QPalette::PlaceholderText));
      item->setToolTip(0, command.action->toolTip());
    }
  none_->setVisible(list_->topLevelItemCount() == 0);
  for (int i = 0; i < list_->topLevelItemCount() && !list_->currentItem(); ++i)
    if (!list_->topLevelItem(i)->isDisabled()) list_->setCurrentItem(list_->topLevelItem(i));
}

QStringList CommandPalette::found() const {
  QStringList texts;
  for (int i = 0; i < list_->topLevelItemCount(); ++i) texts << list_->topLevelItem(i)->text(0);
  return texts;
}

void CommandPalette::run(const QTreeWidgetItem* item) {
  if (!item || item->isDisabled()) return;
  QAction* const action =
      commands_[static_cast<std::size_t>(item->data(0, Qt::UserRole).toInt())].action;
  close();
  // Runs the command later, when the window has the focus again.
  QMetaObject::invokeMethod(action, &QAction::trigger, Qt::QueuedConnection);
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QDialog::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
  if (step == 0 || !list_->currentItem()) return QDialog::eventFilter(watched, event);
  int row = list_->indexOfTopLevelItem(list_->currentItem()) + step;
  while (list_->topLevelItem(row) && list_->topLevelItem(row)->isDisabled()) row += step;
  if (list_->topLevelItem(row)) list_->setCurrentItem(list_->topLevelItem(row));
  return true;
}

}  // namespace mocapress
