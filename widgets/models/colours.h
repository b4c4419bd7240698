// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>
#include <QRgb>
#include <array>
#include <string_view>

#include "core/metrics/visibility.h"

namespace mocapress {

/// Those of Okabe and Ito's colours that can be seen on white and on black. All kinds of colour
/// vision can tell them apart.
inline constexpr std::array<QRgb, 7> kCurveColours = {
    0xff0072b2, 0xffd55e00, 0xff009e73, 0xffcc79a7, 0xffe69f00, 0xff56b4e9, 0xff999999};

/// Marks a note on a frame, on the timeline and in the picture; one of kCurveColours.
inline constexpr QRgb kFrameNoteColour = 0xffe69f00;

/// Distinguishes a series of a study in every plot and table: colour, point shape and line style,
/// so that nobody depends on colour alone.
struct SeriesStyle {
  QColor colour;
  int shape = 0;        // shape of the points, 0 to kSeriesShapes - 1
  bool dashed = false;  // dashes the line
  bool hollow = false;  // draws hollow points: the feet are held
};

inline constexpr int kSeriesShapes = 5;

/// Picks the style by the method's position in compression_methods().
SeriesStyle seriesStyle(std::string_view method, bool feet_held);

/// Returns slate, amber or vermilion. They differ in lightness, and all kinds of colour vision can
/// tell them apart.
QColor sightColour(Sight sight);

/// Returns the colour of an error given as a multiple of the noticeable threshold. Errors below the
/// threshold are darker the smaller they are.
QColor sightColour(double times_noticed);

/// Grades a slide from 0 (a millimetre or less, invisible) to 1 (two centimetres or more).
float slideSeverity(double slid_cm);

/// Goes from teal for a foot that stands to violet for one that slides. People who confuse red and
/// green can tell both colours from each other and from the red figure.
QColor slideColour(double slid_cm);

/// Colours of the scene. The figures can be recognised on a light and on a dark background.
struct SceneColours {
  QColor backdrop_centre, backdrop_edge;
  QColor grid, x_axis, z_axis;
  QColor original;      // ghost of the original
  QColor compressed;    // red figure
  QColor trail;         // trail of a foot that hardly slides
  QColor alert;         // a foot that slides, and its trail
  QColor past, future;  // poses before and after the current frame
  QColor plate;         // texts over the scene
  QColor text;
};

/// Light or dark colours, to match the palette's window.
SceneColours sceneColours(const QPalette& palette);

}  // namespace mocapress
