// SPDX-License-Identifier: MIT
#include "core/codec/format/coded_ends.h"

#include <algorithm>

#include "core/base/byte_cursor.h"
#include "core/base/names_all.h"
#include "core/codec/format/format_error.h"
#include "core/codec/format/range_coder.h"
#include "core/runtime/format/end_poses.h"

namespace mocapress {

std::string_view name(Ends ends) {
  constexpr std::string_view kNames[] = {"free", "even", "exact"};
  static_assert(names_all<Ends>(kNames));
  return kNames[static_cast<std::size_t>(ends)];
}

std::vector<std::byte> CodedEnds::write() const {
  ByteWriter writer;
  using namespace runtime;
  const bool has_velocity = count() > kVelocity;
  writer.write(reaches.frames[kFirstPose]);
  writer.write(
      static_cast<std::uint8_t>(reaches.frames[kLastPose] | (has_velocity ? kVelocityFollows : 0)));
  for (const int end : {kFirstPose, kLastPose})
    writer.write(static_cast<std::int8_t>(step_exponent[end]));
  if (has_velocity) {
    writer.write(reaches.frames[kVelocity]);
    writer.write(static_cast<std::int8_t>(step_exponent[kVelocity]));
  }
  RangeEncoder bits;
  EndCoder coder;
  for (int end = 0; end < count(); ++end)
    for (const int value : steps.col(end)) coder.code(bits, value);
  writer.append(bits.finish());
  return writer.release();
}

CodedEnds read_ends(const runtime::FileSections& sections) {
  CodedEnds ends;
  ends.reaches = sections.end_reaches;
  std::copy_n(sections.end_step_exponent, runtime::kMostEnds, ends.step_exponent.begin());
  runtime::EndReader reader(sections.coded_ends);
  ends.steps.resize(sections.channels, ends.reaches.count());
  for (int end = 0; end < ends.count(); ++end)
    for (int& value : ends.steps.col(end)) value = reader.next();
  require(reader.finish());
  return ends;
}

EndPoses::EndPoses(const CodedEnds& coded, const std::vector<float>& first_steps,
                   const std::vector<float>& last_steps)
    : reaches_(coded.reaches), values_(coded.steps.rows(), coded.steps.cols()) {
  for (int end = 0; end < coded.count(); ++end) {
    const std::vector<float>& steps = end == runtime::kFirstPose ? first_steps : last_steps;
    for (Eigen::Index c = 0; c < values_.rows(); ++c)
      values_(c, end) = runtime::end_value(coded.steps(c, end), steps[c], coded.step_exponent[end]);
  }
}

void EndPoses::add_to(int first_frame, int frames_of_clip, Eigen::MatrixXd& channels) const {
  for (Eigen::Index row = 0; row < channels.rows(); ++row) {
    const int frame = first_frame + static_cast<int>(row);
    for (int end = 0; end < values_.cols(); ++end) {
      const float share = reaches_.share_at(end, frame, frames_of_clip);
      if (share == 0) continue;
      for (Eigen::Index c = 0; c < values_.rows(); ++c)
        channels(row, c) =
            static_cast<double>(static_cast<float>(channels(row, c)) + share * values_(c, end));
    }
  }
}

}  // namespace mocapress
