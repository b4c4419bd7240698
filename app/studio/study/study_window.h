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

/// How far the study is, in a line or two.
QString statusOf(const StudySession& session);

/// What to do first, for an empty plot.
QString hintOf(const StudySession& session);

/// What was asked of the last study, clips left out, from the user's settings.
StudySettings rememberedStudySettings();
void remember(const StudySettings& settings);

/// Where rows are kept unless the user chooses a folder: one for each build of the program, for
/// another may compress otherwise.
QString studyCache();

/// A window beside the studio's: which clips and methods to compare, and the curves and rows that
/// come of it. Closing it cancels.
class StudyWindow : public QWidget {
  Q_OBJECT

 public:
  StudyWindow(StudySession* session, QWidget* parent);

  /// The one that is open, to be studied unless the user chose others.
  void offerClip(const QString& path, const QString& skeleton);

  /// What the studio shows, see StudyResults::setHere().
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
