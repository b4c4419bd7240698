// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace mocapress {

inline constexpr std::string_view kClipLinkScheme = "mocapress:";

/// A link to a place in a clip: "mocapress://open?clip=/motion/walk.bvh&frame=12". Reports contain
/// such links, and the studio opens them.
struct ClipLink {
  std::string clip;                 // absolute path of a motion or .mcpr
  std::optional<std::string> take;  // for a file with several takes
  std::optional<int> frame;         // the first frame is 0
  std::string joint;                // name of a joint; empty: none
  // The view: x, y, z (cm) of the point that the camera looks at, relative to the root; the
  // camera's direction from there as the angle from +z towards +x and the angle above the ground
  // (degrees); its distance (cm).
  std::optional<std::array<double, 6>> camera;

  bool operator==(const ClipLink&) const = default;
};

std::string link_text(const ClipLink& link);

/// Parses what link_text() made; ignores unknown keys. Links come from web pages and mails, so a
/// link may only open a clip by an absolute path on this computer. Throws Error for any other path:
/// a device, a path with "..", or a share, since the share's owner would learn who opens the link.
ClipLink parse_clip_link(std::string_view text);

}  // namespace mocapress
