// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/character_choice.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QToolButton>

namespace mocapress {

CharacterChoice::CharacterChoice(QWidget* parent)
    : QWidget(parent), file_(new QPushButton(this)), remove_(new QToolButton(this)) {
  remove_->setText(QStringLiteral("×"));
  remove_->setAutoRaise(true);
  remove_->setAccessibleName(tr("Take the character off"));
  remove_->setToolTip(tr("Take the character off: each clip has its own mesh, if it has one"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  row->addWidget(file_, 1);
  row->addWidget(remove_);
  connect(file_, &QPushButton::clicked, this, &CharacterChoice::fileRequested);
  connect(remove_, &QToolButton::clicked, this, &CharacterChoice::removed);
  setPath({});
}

void CharacterChoice::setPath(const QString& path) {
  file_->setText(path.isEmpty() ? tr("Each clip's own") : QFileInfo(path).fileName());
  file_->setAccessibleName(tr("Character on all clips: %1").arg(file_->text()));
  const QString why = tr(
      "The mesh of an FBX or glTF that is put on every clip that it fits: errors are measured on "
      "it, and the weighting Skin compresses by it. Other clips keep what they have, and the "
      "report "
      "says so.");
  file_->setToolTip(path.isEmpty() ? QStringLiteral("<p>%1</p>").arg(why)
                                   : QStringLiteral("<p>%1</p><p>%2</p>")
                                         .arg(QDir::toNativeSeparators(path).toHtmlEscaped(), why));
  remove_->setVisible(!path.isEmpty());
}

}  // namespace mocapress
