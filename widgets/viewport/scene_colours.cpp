// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/scene_colours.h"

#include "widgets/models/slide_colour.h"

namespace mocapress {

SceneColours sceneColours(const QPalette& palette) {
  const bool dark = palette.color(QPalette::Window).lightnessF() < 0.5f;
  SceneColours colours;
  colours.backdrop_centre = dark ? QColor(0x42484f) : QColor(0xf6f7f9);
  colours.backdrop_edge = dark ? QColor(0x1d2024) : QColor(0xc9d0d8);
  colours.grid = dark ? QColor(0x9aa4ae) : QColor(0x6c7883);
  colours.x_axis = dark ? QColor(0xd08770) : QColor(0xb8654a);
  colours.z_axis = dark ? QColor(0x6f9fd8) : QColor(0x3f74b5);
  colours.original = dark ? QColor(0xaab3bc) : QColor(0x3f4953);
  colours.compressed = QColor(0xd8352c);
  colours.selected = QColor(0xffb526);
  colours.trail = slideColour(0);
  colours.alert = slideColour(100);
  colours.past = dark ? QColor(0x56b4e9) : QColor(0x0072b2);
  colours.future = QColor(0xe69f00);
  colours.plate = dark ? QColor(0x202327) : QColor(0xffffff);
  colours.text = dark ? QColor(0xe8eaec) : QColor(0x1c2024);
  return colours;
}

}  // namespace mocapress
