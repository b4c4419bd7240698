// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/batch_output.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "widgets/models/colours.h"

namespace mocapress {

BatchOutput::BatchOutput(QWidget* parent)
    : QWidget(parent),
      folder_(new QPushButton(this)),
      names_(new QLineEdit(this)),
      example_(new QLabel(this)),
      bank_(new QComboBox(this)),
      learn_(new QCheckBox(tr("Learn from its clips"), this)),
      overwrite_(new QCheckBox(tr("Replace files that are there"), this)) {
  names_->setAccessibleName(tr("Pattern of the names"));
  names_->setToolTip(
      tr("<p>{folder}: the folder the clip was found by, and those between<br>{stem}: the clip's "
         "name<br>{type}: bvh or amc<br>{preset}, {method}: what it is compressed by</p>"));
  example_->setWordWrap(true);
  example_->setTextFormat(Qt::PlainText);
  overwrite_->setToolTip(
      tr("Otherwise a clip fails, and says so, if its file exists and is not this batch's. Either "
         "way a file is only replaced after the new one was read back and measured."));
  struct Format {
    OutputFormat format;
    QString text, tip;
  };
  const Format formats[] = {
      {OutputFormat::Mcpr, tr("Compressed (.mcpr)"), tr("What is shipped.")},
      {OutputFormat::Bvh, tr("BVH"), tr("The decompressed motion.")},
      {OutputFormat::Amc, tr("ASF/AMC"), tr("The decompressed motion and its skeleton.")},
      {OutputFormat::Csv, tr("CSV"), tr("The decompressed channels as a table.")},
      {OutputFormat::Glb, tr("glTF (.glb)"),
       tr("The decompressed motion on its skeleton, for Blender and engines.")},
      {OutputFormat::Fbx, tr("FBX"),
       tr("The decompressed motion on its skeleton, for Maya, MotionBuilder and engines.")}};
  auto* grid = new QGridLayout;
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(3);
  for (int i = 0; const Format& one : formats) {
    auto* box = new QCheckBox(one.text, this);
    box->setToolTip(one.tip);
    formats_[one.format] = box;
    grid->addWidget(box, i / 2, i % 2);
    ++i;
    connect(box, &QCheckBox::clicked, this, &BatchOutput::change);
  }
  bank_->setAccessibleName(tr("Bank of all clips"));
  bank_->addItem(tr("None"));
  bank_->addItem(tr("Packed"), static_cast<int>(runtime::BankForm::Packed));
  bank_->addItem(tr("Cooked"), static_cast<int>(runtime::BankForm::Cooked));
  bank_->setToolTip(
      tr("<p>All compressed files in one, bank.mcpk, beside them.<br>Packed: the smallest, for "
         "shipping.<br>Cooked: engines sample clips as they lie in it.</p>"));
  learn_->setToolTip(
      tr("Codes the motions of a packed bank by what its clips teach of each other: 1 to 2 % fewer "
         "bytes where there are some hundred, for up to a minute more. A few clips teach nothing, "
         "and their bank stays as it is."));
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(10);
  form->setVerticalSpacing(6);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("Folder"), folder_);
  form->addRow(tr("Names"), names_);
  form->addRow(QString(), example_);
  form->addRow(tr("Files"), grid);
  form->addRow(tr("Bank"), bank_);
  form->addRow(QString(), learn_);
  form->addRow(QString(), overwrite_);
  connect(folder_, &QPushButton::clicked, this, &BatchOutput::folderRequested);
  connect(names_, &QLineEdit::textEdited, this, &BatchOutput::change);
  connect(bank_, &QComboBox::activated, this, &BatchOutput::change);
  connect(learn_, &QCheckBox::clicked, this, &BatchOutput::change);
  connect(overwrite_, &QCheckBox::clicked, this, &BatchOutput::change);
  setSettings({});
}

void BatchOutput::setSettings(const BatchSettings& settings) {
  settings_ = settings;
  folder_->setText(settings.folder.isEmpty() ? tr("Choose…") : QDir(settings.folder).dirName());
  folder_->setAccessibleName(tr("Folder of the batch: %1").arg(folder_->text()));
  folder_->setToolTip(
      settings.folder.isEmpty()
          ? tr("Where files and report go. A batch that the folder holds is resumed.")
          : QDir::toNativeSeparators(settings.folder));
  if (names_->text() != settings.names) names_->setText(settings.names);
  for (const auto& [format, box] : formats_)
    box->setChecked(std::find(settings.formats.begin(), settings.formats.end(), format) !=
                    settings.formats.end());
  bank_->setCurrentIndex(settings.bank ? bank_->findData(static_cast<int>(*settings.bank)) : 0);
  learn_->setChecked(settings.learn);
  learn_->setEnabled(settings.bank == runtime::BankForm::Packed);
  overwrite_->setChecked(settings.overwrite);
}

void BatchOutput::setExample(const QString& example, bool wrong) {
  example_->setText(example);
  QPalette colours = palette();
  colours.setColor(QPalette::WindowText, wrong ? QColor::fromRgb(kCurveColours[1])
                                               : colours.color(QPalette::PlaceholderText));
  example_->setPalette(colours);
}

void BatchOutput::change() {
  settings_.names = names_->text();
  settings_.formats.clear();
  for (const auto& [format, box] : formats_)
    if (box->isChecked()) settings_.formats.push_back(format);
  const QVariant bank = bank_->currentData();
  settings_.bank.reset();
  if (bank.isValid()) settings_.bank = static_cast<runtime::BankForm>(bank.toInt());
  settings_.learn = learn_->isChecked();
  learn_->setEnabled(settings_.bank == runtime::BankForm::Packed);
  settings_.overwrite = overwrite_->isChecked();
  emit settingsChanged(settings_);
}

}  // namespace mocapress
