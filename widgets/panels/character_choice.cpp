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
  remove_->setToolTip(tr("Remove the character; clips with a mesh of their own use that"));
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
  file_->setText(path.isEmpty() ? tr("Own mesh of each clip") : QFileInfo(path).fileName());
  file_->setAccessibleName(tr("Character on all clips: %1").arg(file_->text()));
  const QString why =
      tr("Character (FBX or glTF) for every clip whose joints it fits. Errors are measured on its "
         "mesh, and the weighting Skin uses it. Other clips are unchanged, and the report lists "
         "them.");
  file_->setToolTip(path.isEmpty() ? QStringLiteral("<p>%1</p>").arg(why)
                                   : QStringLiteral("<p>%1</p><p>%2</p>")
                                         .arg(QDir::toNativeSeparators(path).toHtmlEscaped(), why));
  remove_->setVisible(!path.isEmpty());
}

}  // namespace mocapress
