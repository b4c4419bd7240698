// SPDX-License-Identifier: MIT
// Acclaim skeletons. A bone is a Joint whose origin is its parent's bone end; the root's children
// start at the root. Joint frames are parallel to the world at rest, and a bone turns by C R C^-1:
// C from its `axis`, R from its `dof`, where "dof rx ry rz" and "XYZ" both mean Rz * Ry * Rx.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/motion_file.h"
#include "core/motion/clip.h"

namespace mocapress {

/// A joint and its columns in an .amc.
struct AsfJoint {
  Joint joint;                                  // cm
  std::vector<std::optional<ChannelKind>> dof;  // column by column; unset: "l", a bone's length
  std::vector<int> columns;                     // each channel's column; -1: none, always zero
  bool translates_along_axes = false;           // true: joint_from_axes turns translations, too

  /// Sets joint.channels and `columns` from `dof`. The rotation about the first of `rotation_axes`
  /// is applied first.
  void feed_channels(const std::vector<int>& rotation_axes);
};

/// The axes of the rotations in `dof`, in order.
std::vector<int> rotation_axes(const std::vector<std::optional<ChannelKind>>& dof);

struct AsfSkeleton {
  std::string file;
  std::vector<AsfJoint> joints;  // parent-first; joint 0 is "root"
  double cm_per_unit = 1;
  double radians_per_unit = 1;  // unit of angles; an .amc may state another
};

/// Reads the text of an .asf; `file` names it in messages. A unit is 2.54 / length cm, with
/// `length` from :units, unless `cm_per_unit` is given. Throws InputError.
AsfSkeleton read_asf(const std::string& file, std::string_view text,
                     std::optional<double> cm_per_unit = {});

/// The motion with joints that Acclaim can express: joint_from_axes is identity at the root and at
/// joints that translate. asf_text() and amc_text() require this.
Motion acclaim_motion(const Motion& motion);

/// Joint names in an .asf and its .amc: one word each, unique, with "root" for the root.
std::vector<std::string> asf_names(const Skeleton& skeleton);

/// CMU's unit of length: 0.45 units to the inch.
inline constexpr double kAsfCmPerUnit = 2.54 / 0.45;

/// The centimetres per unit to write: the option's if set, else an Acclaim source's, else CMU's.
double asf_cm_per_unit(const SourceFormat& source, const ReadOptions& options = {});

/// The text of an .asf in degrees and the given unit of length. If a child does not start at the
/// end of its parent's bone, a bone without dof, "to_<child>", leads there. Throws WriteError
/// unless the skeleton has one root.
std::string asf_text(const Skeleton& skeleton, double cm_per_unit = kAsfCmPerUnit);

}  // namespace mocapress
