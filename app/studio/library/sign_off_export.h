// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "app/jobs/job_runner.h"
#include "core/report/sign_off.h"

class QWidget;

namespace mocapress {

class Library;
class LibraryModel;

/// The contents of the library's sign-off.
SignOff signOffOf(const Library& library, const LibraryModel& rows);

/// Writes the sign-off of the library as a web page, a table or a PDF, by the extension of the
/// path. Throws WriteError.
void writeSignOff(const QString& path, const SignOff& report);

/// Asks where the sign-off goes, and writes it in the background.
class SignOffExport : public QObject {
  Q_OBJECT

 public:
  SignOffExport(const Library* library, const LibraryModel* rows, QWidget* window);
  ~SignOffExport() override { writing_.finish(); }

  void choose();

 signals:
  void written(const QString& message);
  void failed(const QString& message);

 private:
  void write(const QString& path);

  const Library* library_;
  const LibraryModel* rows_;
  QWidget* window_;
  JobRunner writing_{Workers::LongRunning};
};

}  // namespace mocapress
