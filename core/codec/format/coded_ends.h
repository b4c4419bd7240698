// SPDX-License-Identifier: MIT
// Coded corrections of a clip's first and last pose: FORMAT.md, ENDS.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "core/runtime/format/file_sections.h"

namespace mocapress {

/// The promise for the first and the last pose, where games blend and loop clips. Without one, few
/// coefficients affect these poses, so their errors may be large.
enum class Ends {
  Free,   // promises nothing
  Even,   // their error is at most the target's or, if the target is no error, the clip's
  Exact,  // their error is at most a tenth of that
};

/// "free", "even", "exact".
std::string_view name(Ends ends);

/// Corrections of the first and the last frame and, if reaches[2] is not 0, of the velocity at the
/// last frame. Their unit is the channel's step in the segment at that end, times 2^(-step_exponent
/// / 2). Neighbouring frames get a share of each correction.
struct CodedEnds {
  runtime::EndReaches reaches{{1, 1, 0}};  // frames that corrections reach, the ends included
  std::array<int, runtime::kMostEnds> step_exponent{};
  Eigen::MatrixXi steps;  // channels x (first, last and, if there is one, velocity)

  int count() const { return static_cast<int>(steps.cols()); }

  std::size_t section_bytes() const { return write().size(); }

  /// The payload of ENDS.
  std::vector<std::byte> write() const;
};

/// Reads the ends of a file that has the section ENDS. Throws FormatError.
CodedEnds read_ends(const runtime::FileSections& sections);

/// The corrections of CodedEnds in centimetres and radians, ready to be added.
class EndPoses {
 public:
  /// `first_steps` and `last_steps` are the steps of each channel in the first and in the last
  /// segment.
  EndPoses(const CodedEnds& coded, const std::vector<float>& first_steps,
           const std::vector<float>& last_steps);

  /// Adds the corrections to frames (rows) from first_frame on, of a clip of `frames_of_clip`
  /// frames.
  void add_to(int first_frame, int frames_of_clip, Eigen::MatrixXd& channels) const;

 private:
  runtime::EndReaches reaches_;
  Eigen::MatrixXf values_;  // channels x ends
};

}  // namespace mocapress
