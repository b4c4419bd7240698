// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>

namespace mocapress {

/// What the scene is painted with. The figures stay recognisable on either background.
struct SceneColours {
  QColor backdrop_centre, backdrop_edge;
  QColor grid, x_axis, z_axis;
  QColor original;    // the ghost
  QColor compressed;  // red
  QColor selected;
  QColor trail;         // of a foot that hardly slides
  QColor alert;         // of a foot that does, and its trail
  QColor past, future;  // poses before and after now
  QColor plate;         // what is written over the scene
  QColor text;
};

/// Light or dark, as the palette's window is.
SceneColours sceneColours(const QPalette& palette);

}  // namespace mocapress
