// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/study/study_memory.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

namespace mocapress {
namespace {

const QString kMethods = QStringLiteral("study/methods");
const QString kRatios = QStringLiteral("study/ratios");
const QString kErrors = QStringLiteral("study/errors");
const QString kIkRatio = QStringLiteral("study/ik-ratio");
const QString kWeighting = QStringLiteral("study/weighting");

QVariantList listOf(const std::vector<double>& numbers) {
  return {numbers.begin(), numbers.end()};
}

std::vector<double> numbersOf(const QVariant& list) {
  std::vector<double> numbers;
  for (const QVariant& entry : list.toList())
    if (const double number = entry.toDouble(); number > 0) numbers.push_back(number);
  return numbers;
}

}  // namespace

StudySettings rememberedStudySettings() {
  const QSettings stored;
  StudySettings settings = usualStudySettings();
  if (!stored.contains(kMethods)) return settings;
  settings.methods = stored.value(kMethods).toStringList();
  settings.ratios = numbersOf(stored.value(kRatios));
  settings.errors = numbersOf(stored.value(kErrors));
  if (const double ik = stored.value(kIkRatio).toDouble(); ik > 0) settings.ik_ratio = ik;
  for (const Weighting weighting : kWeightings)
    if (stored.value(kWeighting) == static_cast<int>(weighting)) settings.weighting = weighting;
  return settings;
}

void remember(const StudySettings& settings) {
  QSettings stored;
  stored.setValue(kMethods, settings.methods);
  stored.setValue(kRatios, listOf(settings.ratios));
  stored.setValue(kErrors, listOf(settings.errors));
  stored.setValue(kIkRatio, settings.ik_ratio.value_or(0));
  stored.setValue(kWeighting, static_cast<int>(settings.weighting));
}

QString studyCache() {
  const QFileInfo program(QCoreApplication::applicationFilePath());
  return QStringLiteral("%1/study-%2")
      .arg(QStandardPaths::writableLocation(QStandardPaths::CacheLocation))
      .arg(program.lastModified().toSecsSinceEpoch());
}

}  // namespace mocapress
