// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/codec/encode/encoder.h"
#include "core/codec/encode/named_importance.h"
#include "core/codec/encode/target.h"

namespace mocapress {

/// An IK correction asked for before the skeleton is known.
struct PresetCorrection {
  std::optional<double> ratio;         // r_IK; unset: the encoder finds it
  std::vector<std::string> effectors;  // joints by name; empty: the feet
  IkSolver solver = IkSolver::NearestPose;
  CorrectAt at = CorrectAt::EveryFrame;

  bool operator==(const PresetCorrection&) const = default;
};

/// A contact of one clip, before its skeleton is known.
struct PresetContact {
  std::string point;  // a landmark's name
  int first_frame = 0;
  int last_frame = 0;  // included

  bool operator==(const PresetContact&) const = default;
};

/// By what to compress any clip: EncodeOptions before the skeleton is known.
struct Preset {
  std::string name;
  std::string method = "closed-loop";  // a compression_method's name
  std::optional<Coding> coding;        // unset: the method's usual one
  Weighting weighting = Weighting::BoneEnds;
  Target target{Target::Kind::Error, 0.5};
  std::uint64_t seed = 1;
  Effort effort = Effort::Default;  // not Draft, which promises nothing
  NamedImportance importance;
  Ends ends = Ends::Even;
  std::optional<Loop> loop;                    // unset: the encoder finds whether the clip is one
  std::optional<PresetCorrection> correction;  // unset: without IK correction
  std::optional<std::vector<PresetContact>> contacts;  // edited ones, of the one clip it is for

  bool operator==(const Preset&) const = default;
};

/// "Hero close-up", "Gameplay", "Planted feet", "Crowd", "Archive".
std::span<const Preset> built_in_presets();

/// A name as a word: "hero-close-up".
std::string slug(std::string_view name);

/// The coding it will be; unset for comparison methods.
std::optional<Coding> coding_of(const Preset& preset);

/// Throws Error for what no clip can be compressed by: an unknown method, a coding, target or
/// correction that the method does not have, a target that is not above 0.
void check(const Preset& preset);

/// For one skeleton. Throws Error when an effector or another joint that is named is not of it.
EncodeOptions encode_options(const Preset& preset, const Skeleton& skeleton);

/// "eps_x 0.5 cm", "max 0.5 cm", "not visible", "20:1", "40000 bytes", "r = 30".
std::string target_text(const Target& target);

}  // namespace mocapress
