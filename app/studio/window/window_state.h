// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <utility>

#include "app/studio/document/document.h"
#include "widgets/viewport/orbit_camera.h"
#include "widgets/viewport/view_arrangement.h"

namespace mocapress {

/// State that a window hands on to the next one, which is made in another language.
struct WindowState {
  QString clip;  // its clipKey()
  int frame = 0;
  std::optional<std::pair<int, int>> range;
  Tuning tuning;
  ViewOptions view;
  bool follows = true;
  std::optional<OrbitCamera::Place> camera;  // unset: frames the figure by itself
  int joint = -1;                            // the current one
};

}  // namespace mocapress
