// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/preset_chooser.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>
#include <algorithm>

#include "widgets/models/display_names.h"

namespace mocapress {
namespace {

bool isBuiltIn(const std::string& name) {
  const auto presets = built_in_presets();
  return std::any_of(presets.begin(), presets.end(),
                     [&](const Settings& preset) { return preset.name == name; });
}

}  // namespace

PresetChooser::PresetChooser(QWidget* parent)
    : QWidget(parent), box_(new QComboBox(this)), menu_(new QMenu(this)) {
  box_->setAccessibleName(tr("Preset"));
  box_->setToolTip(
      tr("A preset sets target, method, importance, effort and IK. Your own presets are kept in "
         "the settings of this program."));
  box_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box_->setMinimumContentsLength(14);
  auto* button = new QToolButton(this);
  fillMenu(button);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(box_, 1);
  row->addWidget(button);
  connect(box_, &QComboBox::activated, this, [this](int index) {
    if (index < 0 || index >= static_cast<int>(all_.size())) return;
    const Settings chosen_one = all_[static_cast<std::size_t>(index)];
    setPreset(chosen_one);
    emit chosen(chosen_one);
  });
  preset_ = built_in_presets().front();
  setPresets({built_in_presets().begin(), built_in_presets().end()});
}

void PresetChooser::fillMenu(QToolButton* button) {
  button->setText(QStringLiteral("⋯"));
  button->setAccessibleName(tr("Presets"));
  button->setToolTip(tr("Keep, share and remove presets of your own"));
  // The menu is not set by setMenu(), which adds an arrow. Only a style sheet could remove the
  // arrow, and would keep the old colours when the theme changes.
  connect(button, &QToolButton::clicked, menu_,
          [this, button] { menu_->popup(button->mapToGlobal(QPoint(0, button->height()))); });
  connect(menu_->addAction(tr("Save as Preset…")), &QAction::triggered, this,
          [this] { emit saveRequested(preset_); });
  QAction* rename = menu_->addAction(tr("Rename Preset…"));
  connect(rename, &QAction::triggered, this,
          [this] { emit renameRequested(QString::fromStdString(preset_.name)); });
  QAction* remove = menu_->addAction(tr("Remove Preset"));
  connect(remove, &QAction::triggered, this,
          [this] { emit removeRequested(QString::fromStdString(preset_.name)); });
  menu_->addSeparator();
  connect(menu_->addAction(tr("Import…")), &QAction::triggered, this,
          &PresetChooser::importRequested);
  connect(menu_->addAction(tr("Export…")), &QAction::triggered, this,
          [this] { emit exportRequested(preset_); });
  connect(menu_, &QMenu::aboutToShow, this, [this, rename, remove] {
    const bool own = known(preset_.name) && !isBuiltIn(preset_.name);
    rename->setEnabled(own);
    remove->setEnabled(own);
  });
}

const Settings* PresetChooser::known(const std::string& name) const {
  const auto found =
      std::find_if(all_.begin(), all_.end(), [&](const Settings& one) { return one.name == name; });
  return found == all_.end() ? nullptr : &*found;
}

bool PresetChooser::isPure() const {
  const Settings* origin = known(preset_.name);
  return origin && *origin == preset_;
}

void PresetChooser::setPresets(const std::vector<Settings>& presets) {
  all_ = presets;
  box_->clear();
  for (const Settings& one : all_) {
    box_->addItem(displayName(one));
    const QString purpose = purposeOf(one).isEmpty() ? detailsOf(one) : purposeOf(one);
    box_->setItemData(box_->count() - 1, QStringLiteral("<p>%1</p>").arg(purpose.toHtmlEscaped()),
                      Qt::ToolTipRole);
  }
  setPreset(Settings(preset_));
}

void PresetChooser::setPreset(const Settings& preset) {
  preset_ = preset;
  const auto presets = static_cast<int>(all_.size());
  while (box_->count() > presets) box_->removeItem(presets);
  const Settings* origin = known(preset.name);
  if (isPure()) {
    box_->setCurrentIndex(static_cast<int>(origin - all_.data()));
    return;
  }
  const QString name = displayName(preset);
  box_->addItem(name.isEmpty() ? tr("Custom settings")
                : origin       ? tr("%1, modified").arg(name)
                               : name);
  box_->setCurrentIndex(presets);
}

}  // namespace mocapress
