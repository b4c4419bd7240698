// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QStringList>

namespace mocapress {

/// Ends a test that looked for texts without a translation. The suite skips it then, since whoever
/// adds a text may not speak every language; the release check (MOCAPRESS_RELEASE=1) fails.
inline void endWithUntranslated(const QStringList& texts) {
  if (texts.isEmpty()) return;
  const std::string all = "without a translation:\n" + texts.join(QLatin1Char('\n')).toStdString();
  if (qEnvironmentVariableIsSet("MOCAPRESS_RELEASE")) FAIL() << all;
  GTEST_SKIP() << all;
}

}  // namespace mocapress
