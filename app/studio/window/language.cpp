// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/language.h"

#include <QSettings>

namespace mocapress {
namespace {

const QString kSetting = QStringLiteral("window/language");

}  // namespace

QString chosenLanguage() {
  return QSettings().value(kSetting).toString();
}

void chooseLanguage(const QString& code) {
  QSettings().setValue(kSetting, code);
}

}  // namespace mocapress
