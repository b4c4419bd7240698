// SPDX-License-Identifier: GPL-3.0-or-later
#include "translations/languages.h"

namespace mocapress {

QStringList shippedLanguages() {
  return {QStringLiteral("en"), QStringLiteral("es"), QStringLiteral("fr"), QStringLiteral("ja")};
}

}  // namespace mocapress
