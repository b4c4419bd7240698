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
      learn_(new QCheckBox(tr("Fit the coder to the clips"), this)),
      overwrite_(new QCheckBox(tr("Replace existing files"), this)) {
  names_->setAccessibleName(tr("Pattern of file names"));
  names_->setToolTip(
      tr("<p>{folder}: the folder that was added, and its subfolders down to the clip<br>{stem}: "
         "the clip's name<br>{type}: the source's format, such as bvh<br>{preset}, {method}: the "
         "preset and method of the clip</p>"));
  example_->setWordWrap(true);
  example_->setTextFormat(Qt::PlainText);
  overwrite_->setToolTip(
      tr("If this is off, a clip fails when its file exists and is not from this batch. A file is "
         "replaced only after the new one was read back and measured."));
  struct Format {
    OutputFormat format;
    QString text, tip;
  };
  const Format formats[] = {
      {OutputFormat::Mcpr, tr("Compressed (.mcpr)"), tr("The compressed file, to be shipped.")},
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
      tr("<p>One more file, bank.mcpk, with all compressed clips.<br>Packed: the smallest, for "
         "shipping.<br>Cooked: engines sample its clips without unpacking them.</p>"));
  learn_->setToolTip(
      tr("Fits the statistics of the coder to the clips of a packed bank. This takes up to a "
         "minute and saves 1 to 2 % of the bytes of some hundred clips. A bank of a few clips is "
         "not changed."));
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
          ? tr("Folder for files and report. If it holds a batch, that batch is resumed.")
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
