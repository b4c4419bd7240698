// SPDX-License-Identifier: GPL-3.0-or-later
#include "translations/install.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

namespace mocapress {
namespace {

bool install(QCoreApplication& application, const QLocale& locale, const QString& name,
             const QString& directory) {
  auto* translator = new QTranslator(&application);
  return translator->load(locale, name, QStringLiteral("_"), directory) &&
         QCoreApplication::installTranslator(translator);
}

}  // namespace

void installTranslations(QCoreApplication& application) {
  // A translator that is deleted is no longer installed.
  qDeleteAll(application.findChildren<QTranslator*>(Qt::FindDirectChildrenOnly));
  const QString texts = QStringLiteral(":/i18n");
  const QString name = QStringLiteral("mocapress");
  install(application, QLocale(), QStringLiteral("qtbase"),
          QLibraryInfo::path(QLibraryInfo::TranslationsPath));
  // English is in the source, but for its plural forms.
  if (!install(application, QLocale(), name, texts))
    install(application, QLocale(QLocale::English), name, texts);
}

}  // namespace mocapress
