// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/codec/encoder.h"
#include "core/study/plan.h"

namespace mocapress {

/// An IK correction asked for before the skeleton is known.
struct PresetCorrection {
  std::optional<double> ratio;         // r_IK; unset: the encoder finds it
  std::vector<std::string> effectors;  // joints by name; empty: the feet
  IkSolver solver = IkSolver::NearestPose;
  CorrectAt at = CorrectAt::EveryFrame;

  bool operator==(const PresetCorrection&) const = default;
};

/// By what to compress any clip: EncodeOptions without what belongs to one clip.
struct Preset {
  std::string name;
  std::string method = "closed-loop";  // a contender's name
  std::optional<Coding> coding;        // unset: the method's usual one
  Weighting weighting = Weighting::BoneEnds;
  Target target{Target::Kind::Error, 0.5};
  std::uint64_t seed = 1;
  std::optional<PresetCorrection> correction;  // unset: without IK correction

  bool operator==(const Preset&) const = default;
};

/// "Hero close-up", "Gameplay", "Crowd", "Archive".
std::span<const Preset> built_in_presets();

/// A name as a word: "hero-close-up".
std::string slug(std::string_view name);

/// The coding it will be; unset for comparison methods.
std::optional<Coding> coding_of(const Preset& preset);

/// Throws Error for what no clip can be compressed by: an unknown method, a coding, target or
/// correction that the method does not have, a target that is not above 0.
void check(const Preset& preset);

/// For one skeleton. Throws Error when an effector is no joint of it.
EncodeOptions encode_options(const Preset& preset, const Skeleton& skeleton);

/// "eps_x 0.5 cm", "max 0.5 cm", "20:1", "40000 bytes", "r = 30".
std::string target_text(const Target& target);

}  // namespace mocapress
