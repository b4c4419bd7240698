// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace mocapress {

inline constexpr std::string_view kClipLinkScheme = "mocapress:";

/// A place in a clip, as a link names it: "mocapress://open?clip=/motion/walk.bvh&frame=12". The
/// studio opens it, and reports hold such links.
struct ClipLink {
  std::string clip;                 // a motion or .mcpr, by its absolute path
  std::optional<std::string> take;  // in a file with several
  std::optional<int> frame;         // the first is 0
  std::string joint;                // by name; empty: none
  // x, y, z (cm) of what the camera looks at, from the root; turn from +z towards +x and height
  // above the ground of the eye (degrees), and its distance (cm).
  std::optional<std::array<double, 6>> camera;

  bool operator==(const ClipLink&) const = default;
};

std::string link_text(const ClipLink& link);

/// The inverse of link_text(); keys that it does not know are left out. Links come from web pages
/// and mail, so one opens nothing but a clip by an absolute path on this computer: throws Error for
/// any other, such as a device, a path with "..", or a share, which would be told who asks.
ClipLink parse_clip_link(std::string_view text);

}  // namespace mocapress
