// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>

#include "widgets/viewport/orbit_camera.h"
#include "widgets/viewport/view_arrangement.h"

namespace mocapress {

/// A window's view of the work, handed to the window in another language that replaces it.
struct WindowState {
  int frame = 0;
  std::optional<std::pair<int, int>> range;
  ViewOptions view;
  bool follows = true;
  std::optional<OrbitCamera::Place> camera;  // unset: frames the figure by itself
  bool encodes = false;                      // compresses the library in the background
};

}  // namespace mocapress
