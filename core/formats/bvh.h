// SPDX-License-Identifier: MIT
// Biovision hierarchies. Angles are degrees; the file says neither its unit of length nor whether a
// translation channel adds to the joint's OFFSET or replaces it: bvh_conventions.h guesses both.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/motion_file.h"

namespace mocapress {

/// Reads the text of a .bvh; `file` names it in messages. Throws InputError.
MotionFile read_bvh(const std::string& file, std::string_view text,
                    const ReadOptions& options = {});

/// What a BVH leaves to its reader to know.
struct BvhStyle {
  double cm_per_unit = 1;

  /// Of a root that moves. Unset: its OFFSET is zero, so that both conventions read the same.
  std::optional<TranslationConvention> root;
};

/// As the source was, unless asked otherwise. A root that replaced its OFFSET keeps it. One that
/// added to it gets an OFFSET of zero: everyone reads that, Blender and MotionBuilder too.
BvhStyle bvh_style(const SourceFormat& source, const ReadOptions& options = {});

/// Degrees, in a form that naive readers take: three rotations on every joint, which are zero where
/// the joint has none, and names of one word each, no two alike. A joint below the root with
/// translation channels repeats its OFFSET in them, so that the more widespread convention gives
/// the same motion. Joints turned by ASF's `axis` get the order Z Y X.
std::string bvh_text(const Motion& motion, const BvhStyle& style = {});

/// How bvh_text() names the joints.
std::vector<std::string> bvh_names(const Skeleton& skeleton);

}  // namespace mocapress
