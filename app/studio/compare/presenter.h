// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "widgets/models/joint_error_model.h"
#include "widgets/models/slide_model.h"

namespace mocapress {

class AnnealingPanel;
class CompressionPanel;
class ErrorDisplay;
class ErrorGraph;
class FootskatePanel;
class ImportancePanel;
class JointsPanel;
class Playback;
class ResultPanel;
class Session;
class TransportBar;
class Viewport;

/// Widgets that show a document.
struct Views {
  Viewport* viewport = nullptr;
  CompressionPanel* compression = nullptr;
  ImportancePanel* importance = nullptr;
  ResultPanel* result = nullptr;
  AnnealingPanel* annealing = nullptr;
  JointsPanel* joints = nullptr;
  ErrorGraph* graph = nullptr;
  FootskatePanel* footskate = nullptr;
  TransportBar* transport = nullptr;
};

/// Data of the lists and tables in Views.
struct Models {
  JointErrorModel* joints = nullptr;
  SlideModel* slides = nullptr;
};

/// Shows the session's document in the views, and passes the user's actions on.
class Presenter : public QObject {
  Q_OBJECT

 public:
  Presenter(Session* session, Playback* playback, const Models& models, const Views& views,
            ErrorDisplay* error_display, QObject* parent = nullptr);

 private:
  void connectDocument();
  void connectViews();
  void showClip();
  void showTakes();
  void showOptions();
  void showDecoded();
  void showErrors();
  void showTarget();
  void showShown();
  void showSkin();
  void showSkeleton();
  void showCurves();
  void showCurrentJoint();
  void setChecked(const QString& name, bool checked);
  void toggleJoint(int joint);
  void showFinding(int frame, int landmark);

  Session* session_;
  Playback* playback_;
  Models models_;
  Views views_;
  ErrorDisplay* error_display_;
};

}  // namespace mocapress
