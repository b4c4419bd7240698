// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/own_limits.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/path_kind.h"
#include "core/metrics/sight_limits_json.h"

namespace mocapress {
namespace {

std::filesystem::path path() {
  return ownLimitsFile().toStdU16String();
}

OwnLimits read() {
  try {
    if (!is_there(path())) return {};
    return {limits_from_text(ownLimitsFile().toStdString(), read_text(path())), {}};
  } catch (const Error& error) {
    return {{}, QString::fromUtf8(error.what())};
  }
}

bool areBuiltIn(const SightLimits& limits) {
  return limits.of_cues == SightLimits().of_cues;
}

OwnLimits& kept() {
  static OwnLimits limits = read();
  return limits;
}

}  // namespace

QString ownLimitsFile() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation))
      .filePath(QStringLiteral("limits.json"));
}

const OwnLimits& ownLimits() {
  return kept();
}

void setOwnLimits(const SightLimits& limits) {
  if (areBuiltIn(limits)) {
    QFile file(ownLimitsFile());
    if (file.exists() && !file.remove())
      throw WriteError((file.fileName() + QStringLiteral(": ") + file.errorString()).toStdString());
  } else {
    QDir().mkpath(QFileInfo(ownLimitsFile()).path());
    write_text(path(), limits_to_text(limits));
  }
  kept() = {limits, {}};
}

SightLimits withOwnLimits(SightLimits limits) {
  if (areBuiltIn(limits)) limits.of_cues = ownLimits().limits.of_cues;
  return limits;
}

EncodeSettings withOwnLimits(EncodeSettings options) {
  options.limits = withOwnLimits(options.limits);
  return options;
}

}  // namespace mocapress
