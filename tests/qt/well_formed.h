// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QXmlStreamReader>
#include <string>

namespace mocapress::test {

/// The reason why a page is not well-formed XML; empty: it is.
inline std::string ill_formed(const QString& page) {
  QXmlStreamReader xml(page);
  while (!xml.atEnd()) xml.readNext();
  if (!xml.hasError()) return "";
  return std::to_string(xml.lineNumber()) + ": " + xml.errorString().toStdString();
}

}  // namespace mocapress::test
