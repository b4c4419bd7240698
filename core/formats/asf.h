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

/// A joint and the columns that an .amc gives for it.
struct AsfJoint {
  Joint joint;                                  // cm
  std::vector<std::optional<ChannelKind>> dof;  // column by column; nothing: "l", a bone's length
  std::vector<int> columns;                     // of each channel; -1: none, always zero
  bool translates_along_axes = false;           // translations are to be turned by joint_from_axes

  /// Sets joint.channels and `columns` from `dof`; of the rotations named there, the one about the
  /// first of `rotation_axes` is done first.
  void feed_channels(const std::vector<int>& rotation_axes);
};

/// The axes of the rotations in `dof`, in its order.
std::vector<int> rotation_axes(const std::vector<std::optional<ChannelKind>>& dof);

struct AsfSkeleton {
  std::string file;
  std::vector<AsfJoint> joints;  // parent-first; joint 0 is "root"
  double cm_per_unit = 1;
  double radians_per_unit = 1;  // of angles; an .amc may say otherwise
};

/// Reads the text of an .asf; `file` names it in messages. One unit is 2.54 / length cm, `length`
/// from :units, unless `cm_per_unit` says otherwise. Throws InputError.
AsfSkeleton read_asf(const std::string& file, std::string_view text,
                     std::optional<double> cm_per_unit = {});

/// The motion with every joint as Acclaim can say it: turned axes neither on the root nor beside
/// translations. asf_text() and amc_text() want this.
Motion acclaim_motion(const Motion& motion);

/// How an .asf and its .amc name the joints: one word each, unique, the root "root".
std::vector<std::string> asf_names(const Skeleton& skeleton);

/// CMU's unit of length is 0.45 to the inch.
inline constexpr double kAsfCmPerUnit = 2.54 / 0.45;

/// The source's where that was Acclaim, unless asked otherwise; else CMU's.
double asf_cm_per_unit(const SourceFormat& source, const ReadOptions& options = {});

/// Degrees, the unit of length as given. A child that does not sit at the end of its parent's bone
/// gets a bone without dof, "to_<child>", to carry it there. Throws WriteError
/// unless the skeleton has one root.
std::string asf_text(const Skeleton& skeleton, double cm_per_unit = kAsfCmPerUnit);

}  // namespace mocapress
