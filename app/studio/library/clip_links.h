// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "core/report/clip_link.h"

namespace mocapress {

class Library;
class Playback;
class Session;
class Viewport;
struct OpenRequest;

/// Links to a clip, its frame, a joint and where the camera looks from: core/report/clip_link.h.
class ClipLinks : public QObject {
  Q_OBJECT

 public:
  ClipLinks(Session* session, Library* library, Playback* playback, Viewport* viewport,
            QObject* parent);

  static bool isLink(const QString& text);

  /// Opens the clip of a link and goes to its frame, joint and camera. If the file is not on this
  /// computer, a clip of the library with that file name takes its place.
  void open(const QString& text);

  /// The link to what is shown; empty: no motion is open.
  QString toHere() const;

  /// Copies toHere() to the clipboard.
  void copy();

 signals:
  void copied(const QString& message);
  void failed(const QString& message);

 private:
  void arrive(const OpenRequest& request);

  Session* session_;
  Library* library_;
  Playback* playback_;
  Viewport* viewport_;
  std::optional<ClipLink> under_way_;  // link whose clip is being opened
};

}  // namespace mocapress
