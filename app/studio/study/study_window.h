// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>

#include "app/studio/study/study_session.h"
#include "core/report/curve.h"
#include "widgets/models/study_settings.h"

class QLabel;
class QPushButton;

namespace mocapress {

class StudyPanel;
class StudyResults;
class StudyRowsModel;

/// The study's progress in a line or two.
QString statusOf(const StudySession& session);

/// The next thing to do, for an empty plot.
QString hintOf(const StudySession& session);

/// Settings of the last study without its clips, from the user's settings.
StudySettings rememberedStudySettings();
void remember(const StudySettings& settings);

/// The default folder for rows: one for each build of the program, since another may compress
/// differently.
QString studyCache();

/// The window of a study: clips and methods to compare, and the resulting curves and rows. Closing
/// it cancels the run.
class StudyWindow : public QWidget {
  Q_OBJECT

 public:
  StudyWindow(StudySession* session, QWidget* parent);

  /// Offers the open clip for the study, unless the user chose others.
  void offerClip(const QString& path, const QString& skeleton);

  /// Marks the studio's clip, see StudyResults::setHere().
  void setHere(const QString& path, const std::optional<CurvePoint>& here);

  StudyPanel* panel() { return panel_; }
  StudyResults* results() { return results_; }

 signals:
  void rowChosen(const StudyRow& row);

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  void connectSession();
  void connectPanel();
  QPushButton* makeExportButton();
  void chooseFiles();
  void chooseClipFolder();
  void chooseFolder();
  void showProgress();
  void load(int row);
  QString exportPath(const QString& title, const QString& filter, const QString& ending);

  StudySession* session_;
  StudyRowsModel* model_;
  StudyPanel* panel_;
  StudyResults* results_;
  QPushButton* export_;
  QLabel* note_;
  QString offered_;
};

}  // namespace mocapress
