// SPDX-License-Identifier: MIT
// Settings: how clips are compressed. The library, the command line, the studio's presets and
// projects, batches and studies share this struct, its JSON form and its checks.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/codec/encode/options/effort.h"
#include "core/codec/encode/options/importance.h"
#include "core/codec/encode/options/important_range.h"
#include "core/codec/encode/options/promises.h"
#include "core/codec/encode/options/target.h"
#include "core/codec/format/coded_ends.h"
#include "core/codec/format/coding.h"
#include "core/ik/correction_kind.h"
#include "core/metrics/sight_limits.h"
#include "core/motion/landmarks.h"
#include "core/motion/loop.h"
#include "core/motion/scalar_track.h"

namespace mocapress {

/// Inverse kinematics that holds feet (or other joints) in place when the clip is played.
struct CorrectionSettings {
  std::optional<double> ratio;         // r_IK, above 0: coefficients of the correction / kept ones;
                                       // unset: the encoder finds it
  std::vector<std::string> effectors;  // names of joints; empty: the feet
  IkSolver solver = IkSolver::NearestPose;
  CorrectAt at = CorrectAt::EveryFrame;

  bool operator==(const CorrectionSettings&) const = default;
};

/// A contact of a foot with the ground in one clip, as edited by somebody.
struct ContactSetting {
  std::string point;  // name of a landmark: a joint's, or "<joint> end"
  int first_frame = 0;
  int last_frame = 0;  // included

  bool operator==(const ContactSetting&) const = default;
};

/// Settings to compress any clip. encode_settings() translates them for one clip, with joints by
/// index.
struct Settings {
  std::string name;  // name of a preset; empty: none
  // "closed-loop", the best one; "annealed", "standard", "per-channel", "haar", "linear"; or a
  // comparison method, which no engine plays: see `mocapress compress --help`.
  std::string method = "closed-loop";
  std::optional<Coding> coding;              // unset: the method's usual one
  Weighting weighting = Weighting::Surface;  // points on which errors are measured
  Target target{Target::Kind::Error, 0.5};   // by default an error of 0.5 cm
  std::uint64_t seed = 1;                    // for annealing; equal seeds give equal bytes
  Effort effort = Effort::Default;           // may not be Draft, which promises nothing
  NamedImportance importance;                // parts of the body that get more weight
  Promises promises;                         // further bounds, if the target is an error
  SightLimits limits;                        // thresholds of what people notice, and the distance
  Ends ends = Ends::Even;                    // bounds on the errors of first and last pose
  std::optional<Loop> loop;                  // unset: the encoder detects if it is a loop
  double track_error = kUsualTrackError;     // largest error of any value of a scalar track
  std::optional<CorrectionSettings> correction;         // unset: no IK correction
  std::optional<std::vector<ContactSetting>> contacts;  // edited contacts, for one clip only
  std::vector<ImportantRange> ranges;  // frames that get more weight, for one clip only

  bool operator==(const Settings&) const = default;
};

/// Throws Error for settings that cannot compress any clip: an unknown method; a coding, target or
/// correction that the method does not support; a target that is not above 0.
void check(const Settings& settings);

/// One JSON object on one line, which settings_from_json() reads:
///   {"name": "Mine", "method": "closed-loop", "coding": null, "weighting": "surface",
///    "target": {"kind": "error", "value": 0.5}, "seed": 1,
///    "ik": {"ratio": "auto", "effectors": [], "solver": "nearest-pose", "at": "every-frame"},
///    "effort": "best", "importance": {"feet": 4, "lwrist": 2, "contacts": 20},
///    "limits": {"distance_m": 2}, "promises": {"head_degrees": 2.5, "hand_degrees": 4,
///    "finger_degrees": 6, "root_cm": 0.2, "root_degrees": 0.3}, "ends": "even", "loop": "none",
///    "track_error": 0.001, "contacts": [{"joint": "lfoot", "first_frame": 10, "last_frame": 25}],
///    "importance_ranges": [{"first_frame": 40, "last_frame": 80, "factor": 2}]}
std::string settings_to_json(const Settings& settings);

/// Reads settings from JSON. Missing keys have the values of Settings{}; "ik": null means no
/// correction. Throws InputError: with line and column for a text that is not JSON, with the key
/// for an unknown key or a wrong value, and with the reason for settings that check() refuses.
Settings settings_from_json(const std::string& text);

/// The presets "Hero close-up", "Gameplay", "Planted feet", "Crowd" and "Archive". The limits of
/// each hold the distance from which its results are meant to be watched.
std::span<const Settings> built_in_presets();

/// Finds a built-in preset by its name or slug(), or else reads the first preset of a file. Throws
/// InputError.
Settings find_preset(const std::string& name_or_file);

/// Makes a single word of a name: "hero-close-up".
std::string slug(std::string_view name);

/// The coding that a clip compressed by these settings has; unset for comparison methods.
std::optional<Coding> coding_of(const Settings& settings);

/// Describes a target: "eps_x 0.5 cm", "max 0.5 cm", "not visible", "20:1", "40000 bytes", "r =
/// 30".
std::string target_text(const Target& target);

}  // namespace mocapress
