// SPDX-License-Identifier: MIT
// The first and the last pose of a clip, coded once more: FORMAT.md, ENDS.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "core/runtime/format/file_sections.h"

namespace mocapress {

/// What is promised of the first and the last pose, where few coefficients share in an error and
/// games blend and loop.
enum class Ends {
  Free,   // nothing
  Even,   // they are no further off than the target or, where that is no error, the clip
  Exact,  // a tenth of that
};

/// "free", "even", "exact".
std::string_view name(Ends ends);

/// What the first and the last frame of a clip lack, in steps of their segment's channels times
/// 2^(-step_exponent / 2), and where that has a reach, the velocity at one of them. The frames
/// beside them take part in it.
struct CodedEnds {
  runtime::EndReaches reaches{{1, 1, 0}};  // those at the ends counted
  std::array<int, runtime::kMostEnds> step_exponent{};
  Eigen::MatrixXi steps;  // channels x (first, last and, if there is one, velocity)

  int count() const { return static_cast<int>(steps.cols()); }

  std::size_t section_bytes() const { return write().size(); }

  /// The payload of ENDS.
  std::vector<std::byte> write() const;
};

/// The ends of a file that has them. Throws FormatError.
CodedEnds read_ends(const runtime::FileSections& sections);

/// The same in centimetres and radians, ready to be added.
class EndPoses {
 public:
  /// Steps of each channel in the first and in the last segment.
  EndPoses(const CodedEnds& coded, const std::vector<float>& first_steps,
           const std::vector<float>& last_steps);

  /// Adds them to frames (rows) of a clip of so many, from first_frame on.
  void add_to(int first_frame, int frames_of_clip, Eigen::MatrixXd& channels) const;

 private:
  runtime::EndReaches reaches_;
  Eigen::MatrixXf values_;  // channels x ends
};

}  // namespace mocapress
