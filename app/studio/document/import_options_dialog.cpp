// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/import_options_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <cmath>

#include "app/jobs/clips.h"
#include "core/formats/amc.h"

namespace mocapress {
namespace {

constexpr int kAutomatic = 0;  // the first entry of each chooser

/// A row of a chooser and the field for the number of its last entry.
QWidget* withField(QComboBox* chooser, QDoubleSpinBox* field) {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins({});
  layout->addWidget(chooser, 1);
  layout->addWidget(field);
  const auto show = [=] { field->setEnabled(chooser->currentIndex() == chooser->count() - 1); };
  QObject::connect(chooser, &QComboBox::currentIndexChanged, field, show);
  show();
  return row;
}

/// The value of the chosen entry: none for the first, the field's number for the last.
std::optional<double> valueOf(const QComboBox* chooser, const QDoubleSpinBox* field) {
  if (chooser->currentIndex() == kAutomatic) return std::nullopt;
  if (chooser->currentIndex() == chooser->count() - 1) return field->value();
  return chooser->currentData().toDouble();
}

void setValue(QComboBox* chooser, QDoubleSpinBox* field, const std::optional<double>& value) {
  if (!value) return chooser->setCurrentIndex(kAutomatic);
  field->setValue(*value);
  for (int i = 1; i + 1 < chooser->count(); ++i)
    if (std::abs(chooser->itemData(i).toDouble() - *value) <= 1e-9 * *value)
      return chooser->setCurrentIndex(i);
  chooser->setCurrentIndex(chooser->count() - 1);
}

QDoubleSpinBox* makeField(double smallest, double largest, int decimals, const QString& suffix) {
  auto* field = new QDoubleSpinBox;
  field->setDecimals(decimals);
  field->setRange(smallest, largest);
  field->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  field->setSuffix(suffix);
  return field;
}

}  // namespace

ImportOptionsDialog::ImportOptionsDialog(const OriginalClip& clip, QWidget* parent)
    : QDialog(parent),
      unit_(new QComboBox),
      cm_per_unit_(makeField(1e-6, 1e6, 6, tr(" cm"))),
      up_(new QComboBox),
      root_(new QComboBox),
      rate_(new QComboBox),
      rate_hz_(makeField(0.01, 1e5, 4, tr(" Hz"))) {
  setWindowTitle(tr("Import Options – %1").arg(QFileInfo(clip.path).fileName()));
  const SourceFormat& source = clip.source;
  const bool bvh = source.kind == SourceFormat::Kind::Bvh;

  const bool says_all =
      source.kind == SourceFormat::Kind::Fbx || source.kind == SourceFormat::Kind::Gltf;

  unit_->addItem(says_all ? tr("As in the file")
                 : bvh    ? tr("Guessed by the figure's height")
                          : tr("As in the skeleton file"));
  unit_->addItem(tr("Centimetre"), 1.0);
  unit_->addItem(tr("Metre"), 100.0);
  unit_->addItem(tr("Millimetre"), 0.1);
  unit_->addItem(tr("Inch"), 2.54);
  unit_->addItem(tr("CMU's unit (0.45 to the inch)"), 2.54 / 0.45);
  unit_->addItem(tr("Other"));
  cm_per_unit_->setValue(source.cm_per_unit);
  up_->addItem(says_all ? tr("As in the file") : tr("Y, as usual"));
  up_->addItem(QStringLiteral("Y"), static_cast<int>(UpAxis::Y));
  up_->addItem(QStringLiteral("Z"), static_cast<int>(UpAxis::Z));
  root_->addItem(tr("Guessed by the root's values"));
  root_->addItem(tr("Adds to its OFFSET"), static_cast<int>(TranslationConvention::Adds));
  root_->addItem(tr("Replaces its OFFSET"), static_cast<int>(TranslationConvention::Replaces));
  rate_->addItem(clip.states_rate ? tr("As in the file")
                                  : tr("%L1 Hz, CMU's: the file does not say").arg(kUsualAmcRate));
  for (const double hz : {24.0, 25.0, 30.0, 60.0, 100.0, 120.0})
    rate_->addItem(tr("%L1 Hz").arg(hz), hz);
  rate_->addItem(tr("Other"));
  rate_hz_->setValue(clip.motion().clip.sample_rate_hz);

  auto* form = new QFormLayout;
  form->addRow(tr("&Length unit"), withField(unit_, cm_per_unit_));
  form->addRow(tr("&Up axis"), up_);
  form->addRow(tr("Frame &rate"), withField(rate_, rate_hz_));
  form->addRow(tr("BVH r&oot"), root_);
  form->labelForField(root_)->setVisible(bvh);
  root_->setVisible(bvh);
  unit_->setAccessibleName(tr("Length unit"));
  rate_->setAccessibleName(tr("Frame rate"));
  cm_per_unit_->setAccessibleName(tr("Centimetres in one unit"));
  rate_hz_->setAccessibleName(tr("Frames per second"));
  qobject_cast<QLabel*>(form->labelForField(unit_->parentWidget()))->setBuddy(unit_);
  qobject_cast<QLabel*>(form->labelForField(rate_->parentWidget()))->setBuddy(rate_);

  QString now = tr("Now read with %L1 cm to the unit, %2 up, %L3 Hz")
                    .arg(source.cm_per_unit, 0, 'g', 6)
                    .arg(source.up == UpAxis::Y ? QStringLiteral("Y") : QStringLiteral("Z"))
                    .arg(clip.motion().clip.sample_rate_hz, 0, 'g', 6);
  if (source.root)
    now += *source.root == TranslationConvention::Adds ? tr(", the root adds to its OFFSET")
                                                       : tr(", the root replaces its OFFSET");
  auto* summary = new QLabel(now);
  summary->setWordWrap(true);

  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel |
                                       QDialogButtonBox::RestoreDefaults);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
          [this] { setOptions({}); });

  auto* layout = new QVBoxLayout(this);
  layout->addWidget(summary);
  layout->addLayout(form);
  layout->addWidget(buttons);
  // Without this order, Tab would skip some of the buttons.
  using Box = QDialogButtonBox;
  setTabOrder(buttons->button(Box::RestoreDefaults), buttons->button(Box::Ok));
  setTabOrder(buttons->button(Box::Ok), buttons->button(Box::Cancel));
  setOptions(clip.reading);
}

ReadOptions ImportOptionsDialog::options() const {
  ReadOptions options{.sample_rate_hz = valueOf(rate_, rate_hz_),
                      .cm_per_unit = valueOf(unit_, cm_per_unit_),
                      .take = take_};
  if (up_->currentIndex() != kAutomatic)
    options.up = static_cast<UpAxis>(up_->currentData().toInt());
  if (root_->currentIndex() != kAutomatic)
    options.bvh_root = static_cast<TranslationConvention>(root_->currentData().toInt());
  return options;
}

void ImportOptionsDialog::setOptions(const ReadOptions& options) {
  take_ = options.take;
  setValue(unit_, cm_per_unit_, options.cm_per_unit);
  setValue(rate_, rate_hz_, options.sample_rate_hz);
  up_->setCurrentIndex(options.up ? up_->findData(static_cast<int>(*options.up)) : kAutomatic);
  root_->setCurrentIndex(options.bvh_root ? root_->findData(static_cast<int>(*options.bvh_root))
                                          : kAutomatic);
}

}  // namespace mocapress
