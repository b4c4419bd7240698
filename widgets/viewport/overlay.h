// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QPointF>
#include <QRectF>
#include <QSize>
#include <QSizeF>
#include <QString>
#include <Qt3DCore/QEntity>
#include <array>
#include <optional>
#include <vector>

#include "widgets/models/colours.h"
#include "widgets/models/error_colour.h"
#include "widgets/viewport/shader_material.h"
#include "widgets/viewport/view_arrangement.h"

namespace mocapress {

class PaintedImage;

/// A small picture over the scene, since widgets cannot cover a 3D window.
class SceneLabel : public Qt3DCore::QEntity {
 public:
  explicit SceneLabel(QNode* parent);

  /// Shows the picture at a rectangle of a view whose size is `view`, both in logical pixels.
  void show(const QImage& picture, const QRectF& place, const QSizeF& view);
  void hide();

 private:
  PaintedImage* image_;
  ShaderMaterial* material_;
};

/// The contents of the overlay, and the sizes that it is drawn for.
struct OverlayContent {
  Arrangement arrangement;
  bool has_original = false;
  bool has_compressed = false;
  std::vector<PinnedFigure> pinned;
  std::optional<ErrorScale> scale;  // scale of a figure coloured by error
  double exaggeration = 1;          // factor on the differences that are shown
  QSize view;                       // logical pixels
  double pixel_ratio = 1;           // device pixels per logical pixel
};

/// A note in the picture: a mark, and its text beside it.
struct OverlayNote {
  QPointF at;  // logical pixels
  QString text;
};

/// Draws over the scene: the titles of the figures, the divider between them, the scale of error
/// colours, notes, the factor of exaggerated differences, and the names of a quartered window's
/// views.
class Overlay : public Qt3DCore::QEntity {
 public:
  explicit Overlay(QNode* parent);

  void setColours(const SceneColours& colours) { colours_ = colours; }
  void show(const OverlayContent& content);
  void showNotes(const std::vector<OverlayNote>& notes, const QSize& view, double pixel_ratio);

  /// The labels for the frame graph, as groups in drawing order.
  std::vector<std::vector<Qt3DCore::QEntity*>> labels() const;

 private:
  void showTitles(const OverlayContent& content);
  void showLegend(const OverlayContent& content);
  void showDivider(const OverlayContent& content);
  void showNote(SceneLabel* label, const QString& text, const QPointF& corner, bool warns,
                const OverlayContent& content);
  void showQuarters(const OverlayContent& content);

  SceneColours colours_;
  std::array<SceneLabel*, kMostPanes> titles_;  // original, compressed, pinned
  SceneLabel* legend_;
  std::array<SceneLabel*, kMostPanes - 1> lines_;  // between panes
  SceneLabel* grip_;
  static constexpr std::size_t kMostNotes = 4;
  std::array<SceneLabel*, kMostNotes> notes_;
  SceneLabel* exaggeration_;
  std::array<SceneLabel*, kQuarters - 1> quarters_;  // names of the front, side and top view
};

}  // namespace mocapress
