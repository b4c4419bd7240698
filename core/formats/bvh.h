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

/// Properties of a BVH that its text does not state.
struct BvhStyle {
  double cm_per_unit = 1;

  /// The convention of a root that moves. Unset: its OFFSET is zero, and both conventions agree.
  std::optional<TranslationConvention> root;
};

/// The style of a BVH to be written: the source's, unless options ask otherwise. A root that
/// replaced its OFFSET keeps doing so. A root that added to it gets an OFFSET of zero, which every
/// program reads alike, Blender and MotionBuilder included.
BvhStyle bvh_style(const SourceFormat& source, const ReadOptions& options = {});

/// The text of a BVH, in degrees and in a form that simple readers accept. Every joint has three
/// rotations, with zeros for those it lacks. Each name is one word, and unique. A joint below the
/// root with translation channels repeats its OFFSET in them, so that the more widespread
/// convention gives the same motion. Joints turned by ASF's `axis` get the order Z Y X.
std::string bvh_text(const Motion& motion, const BvhStyle& style = {});

/// The joint names that bvh_text() writes.
std::vector<std::string> bvh_names(const Skeleton& skeleton);

}  // namespace mocapress
