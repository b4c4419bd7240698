// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QObject>
#include <vector>

#include "app/studio/document.h"

namespace mocapress {

class PinnedModel;
class PinnedPanel;
class Session;
class Viewport;

/// Results of the open clip that stay in view while other settings are tried. They go with the
/// clip.
class PinnedResults : public QObject {
  Q_OBJECT

 public:
  PinnedResults(Session* session, PinnedModel* model, PinnedPanel* panel, Viewport* viewport,
                QObject* parent = nullptr);

  /// There is a final result to the settings, measured, that is not pinned yet, and room for it.
  bool canPin() const;

  void pinCurrent();
  void unpin(int row);
  void rename(int row, const QString& name);

  /// Its settings become the document's, which can be undone.
  void makeCurrent(int row);

 signals:
  void canPinChanged(bool can);

 private:
  struct Pin {
    QString name;
    QColor colour;
    DecodedPtr decoded;
    EncodeOptions options;
  };

  QColor freeColour() const;
  void setFinal(bool final);
  void show();
  void showWhetherToPin();

  Session* session_;
  PinnedModel* model_;
  PinnedPanel* panel_;
  Viewport* viewport_;
  std::vector<Pin> pins_;
  bool final_ = false;  // the result is that of the document's options
};

}  // namespace mocapress
