// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>
#include <QRgb>
#include <array>
#include <string_view>

#include "core/metrics/visibility.h"

namespace mocapress {

/// Okabe and Ito's colours, told apart by all kinds of colour vision; those that hold on white and
/// on black.
inline constexpr std::array<QRgb, 7> kCurveColours = {
    0xff0072b2, 0xffd55e00, 0xff009e73, 0xffcc79a7, 0xffe69f00, 0xff56b4e9, 0xff999999};

/// What tells the series of a study apart, in every plot and table the same: colour, shape of the
/// points and kind of line, so that colour is never needed alone.
struct SeriesStyle {
  QColor colour;
  int shape = 0;        // of the points, 0 to kSeriesShapes - 1
  bool dashed = false;  // the line
  bool hollow = false;  // the points: with the feet held
};

inline constexpr int kSeriesShapes = 5;

/// By the method's place among compression_methods().
SeriesStyle seriesStyle(std::string_view method, bool feet_held);

/// Slate, amber, vermilion: told apart in all kinds of colour vision and by how light they are.
QColor sightColour(Sight sight);

/// The same by how many times an error is what is noticed: what is not visible is the darker the
/// less there is of it.
QColor sightColour(double times_noticed);

/// How bad a slide is, 0 ... 1: a millimetre is nothing to be seen, two centimetres are as bad as
/// it gets.
float slideSeverity(double slid_cm);

/// From the teal of a foot that stands to the violet of one that slides: told apart without red and
/// green, and from a red figure.
QColor slideColour(double slid_cm);

/// What the scene is painted with. The figures stay recognisable on either background.
struct SceneColours {
  QColor backdrop_centre, backdrop_edge;
  QColor grid, x_axis, z_axis;
  QColor original;      // the ghost
  QColor compressed;    // red
  QColor trail;         // of a foot that hardly slides
  QColor alert;         // of a foot that does, and its trail
  QColor past, future;  // poses before and after now
  QColor plate;         // what is written over the scene
  QColor text;
};

/// Light or dark, as the palette's window is.
SceneColours sceneColours(const QPalette& palette);

}  // namespace mocapress
