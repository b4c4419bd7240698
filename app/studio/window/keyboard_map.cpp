// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/keyboard_map.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace mocapress {
namespace {

constexpr QSize kMapSize(640, 620);

QString keyText(const QKeySequence& key) {
  return key.toString(QKeySequence::NativeText);
}

}  // namespace

KeyboardMap::KeyboardMap(std::vector<Command> commands, QWidget* parent)
    : QDialog(parent),
      words_(new QLineEdit(this)),
      list_(new QTreeWidget(this)),
      key_(new QKeySequenceEdit(this)),
      assign_(new QPushButton(tr("Assign"), this)),
      clear_(new QPushButton(tr("No Key"), this)),
      usual_(new QPushButton(tr("Usual Key"), this)),
      conflict_(new QLabel(this)) {
  std::erase_if(commands,
                [](const Command& command) { return command.action->objectName().isEmpty(); });
  commands_ = std::move(commands);
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Keyboard Map"));
  resize(kMapSize);
  words_->setPlaceholderText(tr("Words of a command, or a key"));
  words_->setAccessibleName(tr("Words of a command"));
  words_->setClearButtonEnabled(true);
  list_->setAccessibleName(tr("Commands"));
  list_->setHeaderLabels({tr("Command"), tr("Menu"), tr("Key")});
  list_->setRootIsDecorated(false);
  list_->setAlternatingRowColors(true);
  list_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  key_->setAccessibleName(tr("New key"));
  // The inner field of key_ is what gets the focus.
  for (QLineEdit* field : key_->findChildren<QLineEdit*>()) field->setAccessibleName(tr("New key"));
  conflict_->setWordWrap(true);
  conflict_->setMinimumHeight(2 * fontMetrics().lineSpacing());

  auto* all = new QPushButton(tr("Usual Keys for All"), this);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  buttons->addButton(all, QDialogButtonBox::ResetRole);
  for (QPushButton* button : {assign_, clear_, usual_, all}) button->setAutoDefault(false);
  auto* row = new QHBoxLayout;
  row->addWidget(key_, 1);
  row->addWidget(assign_);
  row->addWidget(clear_);
  row->addWidget(usual_);
  auto* column = new QVBoxLayout(this);
  column->addWidget(words_);
  column->addWidget(list_, 1);
  column->addLayout(row);
  column->addWidget(conflict_);
  column->addWidget(buttons);

  connect(words_, &QLineEdit::textChanged, this, &KeyboardMap::find);
  connect(list_, &QTreeWidget::currentItemChanged, this, &KeyboardMap::showChosen);
  connect(key_, &QKeySequenceEdit::keySequenceChanged, this, &KeyboardMap::showConflict);
  connect(assign_, &QPushButton::clicked, this, [this] { assign(key_->keySequence()); });
  connect(clear_, &QPushButton::clicked, this, [this] { assign({}); });
  connect(usual_, &QPushButton::clicked, this, [this] { assign(chosen()->usual); });
  connect(all, &QPushButton::clicked, this, &KeyboardMap::resetAll);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    auto* item =
        new QTreeWidgetItem(list_, {nameOf(*commands_[i].action), commands_[i].menus, QString()});
    item->setForeground(1, palette().color(QPalette::PlaceholderText));
  }
  fill();
  list_->setCurrentItem(list_->topLevelItem(0));
}

const Command* KeyboardMap::chosen() const {
  const int row = list_->indexOfTopLevelItem(list_->currentItem());
  return row < 0 ? nullptr : &commands_[static_cast<std::size_t>(row)];
}

/// Shows the keys, in bold where they are not the usual ones.
void KeyboardMap::fill() {
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    const Command& command = commands_[static_cast<std::size_t>(i)];
    QTreeWidgetItem* item = list_->topLevelItem(i);
    item->setText(2, keyText(command.action->shortcut()));
    QFont font = list_->font();
    font.setBold(command.action->shortcut() != command.usual);
    item->setFont(2, font);
  }
  showChosen();
}

void KeyboardMap::find(const QString& words) {
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = list_->topLevelItem(i);
    const QString all =
        item->text(1) + QLatin1Char(' ') + item->text(0) + QLatin1Char(' ') + item->text(2);
    bool fits = true;
    for (const QString& word : words.split(QLatin1Char(' '), Qt::SkipEmptyParts))
      fits = fits && all.contains(word, Qt::CaseInsensitive);
    item->setHidden(!fits);
  }
}

void KeyboardMap::showChosen() {
  const Command* command = chosen();
  for (QWidget* widget : std::initializer_list<QWidget*>{key_, clear_, usual_})
    widget->setEnabled(command);
  if (command) {
    key_->setKeySequence(command->action->shortcut());
    usual_->setEnabled(command->action->shortcut() != command->usual);
    clear_->setEnabled(!command->action->shortcut().isEmpty());
  }
  showConflict();
}

void KeyboardMap::showConflict() {
  const Command* command = chosen();
  const QKeySequence key = key_->keySequence();
  // A command has a single key, not a sequence of keys: the last one counts.
  if (key.count() > 1)
    return key_->setKeySequence(QKeySequence(key[static_cast<uint>(key.count() - 1)]));
  assign_->setEnabled(command && !key.isEmpty() && key != command->action->shortcut());
  const Command* holder = command ? holderOf(key, commands_, command->action) : nullptr;
  conflict_->setText(holder ? tr("%1 belongs to “%2”, which loses it when you assign it.")
                                  .arg(keyText(key), nameOf(*holder->action))
                            : QString());
}

void KeyboardMap::assign(const QKeySequence& key) {
  const Command* command = chosen();
  if (!command) return;
  if (const Command* holder = holderOf(key, commands_, command->action)) chooseKey(*holder, {});
  chooseKey(*command, key);
  fill();
}

void KeyboardMap::resetAll() {
  for (const Command& command : commands_) chooseKey(command, command.usual);
  fill();
}

}  // namespace mocapress
