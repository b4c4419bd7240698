// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/compare/contender.h"
#include "core/study/plan.h"
#include "core/study/row.h"

namespace mocapress {

/// A clip of a study with all that its rows have in common.
class ClipInHand {
 public:
  /// Throws InputError when it cannot be read.
  ClipInHand(const StudyPlan& plan, const std::filesystem::path& path);

  const ContenderEncoder& encoder() const { return encoder_; }
  const Motion& motion() const { return encoder_.wavelets().motion(); }
  const std::string& fingerprint() const { return fingerprint_; }
  const Warnings& warnings() const { return warnings_; }
  const SourceFormat& source() const { return source_; }

  /// Spans in which a foot is planted, in the original.
  const std::vector<ContactSpan>& contacts() const { return encoder_.wavelets().contacts(); }

  /// `contacts`: of edited ones, over which the footskate of the compression was measured.
  Measurement measure(const Compression& compression,
                      std::optional<std::size_t> contacts = {}) const;

 private:
  explicit ClipInHand(MotionFile file);

  Warnings warnings_;
  SourceFormat source_;
  std::string fingerprint_;
  ContenderEncoder encoder_;
};

}  // namespace mocapress
