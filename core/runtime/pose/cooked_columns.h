// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/runtime/decode/clip.h"
#include "core/runtime/format/memory.h"
#include "core/runtime/format/result.h"
#include "core/runtime/pose/cooked_clip.h"
#include "core/runtime/pose/cooked_coefficients.h"

namespace mocapress::runtime {

/// Where the channels of a clip go: which of them change, in which columns their rows are, where
/// the kernel for eight joints wants them, and how columns make poses.
class CookedColumns {
 public:
  static constexpr int kFewestBands = 4;  // of details that are kept, and most
  static constexpr int kMostBands = 5;

  struct Channel {
    double factor = 1;    // of its values in columns: 1/2 for angles
    double constant = 0;  // its value where it has but one
    double least = 0;     // of its samples after the bands that would be kept
    double most = 0;
    double furthest = 0;  // magnitude of its values at frames, ends included; of angles
    std::int32_t largest[kMostKeptBands] = {};  // magnitude in each of the finest bands
    std::uint16_t joint = 0;
    std::uint8_t kind = 0;
    bool changes = false;
    bool is_wide = false;
    std::int32_t column = -1;
  };
  /// A joint in a RotorGroup: its channels, of up to three axes.
  struct Rotor {
    std::uint16_t joint = 0;
    std::uint8_t angles = 0;
    std::uint8_t are_near = 7;  // a bit for each that stays within a quarter of a turn
    std::uint16_t channel[3] = {};

    /// How many do not.
    int far() const { return 3 - std::popcount(are_near); }
  };
  struct Column {
    std::int32_t channel = -1;  // -1: none
    double base = 0;            // added to it
    double factor = 1;
    bool is_free = false;  // for any channel
  };
  struct Turn {
    OtherTurn made;
    std::int32_t channel = -1;  // -1: it is constant
    bool is_after = false;      // the constant after the angles, not before
  };

  /// With measuring memory only to know how much.
  CookedColumns(Memory& memory, const ClipBlock& clip, CookedCoefficients& coefficients);

  /// Finds out what each channel needs, and which columns there will be.
  mcpr_result place();

  /// So many in the parts that are not wide.
  void keep_bands(int bands);

  int groups() const { return groups_; }
  int row_groups() const { return row_groups_; }  // others get their values from these
  const Channel& channel(int number) const { return channels_[number]; }
  const Column& column(int number) const { return columns_[number]; }
  std::span<const Rotor> rotors() const { return span_of(rotors_, rotor_count_); }
  const int (&vectors(int rotor_group) const)[3] { return vectors_[rotor_group]; }  // their groups
  std::span<const MovingAxis> moving() const { return span_of(moving_, moving_count_); }
  std::span<const AddedColumn> added() const { return span_of(added_, added_count_); }
  std::span<const Turn> turns() const { return span_of(turns_, turn_count_); }
  std::span<const CookedPart> parts() const { return span_of(parts_, part_count_); }

 private:
  template <typename T>
  static std::span<const T> span_of(const T* first, int count) {
    return {first, static_cast<std::size_t>(count)};
  }
  int channel_count() const { return static_cast<int>(clip_.channel_count); }
  void analyse_segment(int segment);
  void see_angles(int channel, int segment);
  bool is_near(const Channel& channel) const;
  void choose_wide();
  void fill_wide();
  mcpr_result place_columns();
  bool place_full_vectors();
  bool place_others(bool wide);
  bool place_gathered_vectors();
  void place_offsets();
  int new_group();
  std::int32_t place(int channel);
  void place_joint(int joint);

  static constexpr std::int32_t kMostValue = 2047;  // of a kept coefficient; more goes into samples
  static constexpr double kMostRange = 3.9;         // of 16-bit samples, radians or cm

  const ClipBlock& clip_;
  CookedCoefficients& coefficients_;
  int wide_bands_ = kFewestBands;
  Channel* channels_;
  Rotor* rotors_;
  int rotor_count_ = 0;
  Column* columns_;
  int groups_ = 0;
  int normal_groups_ = 0;
  int row_groups_ = 0;
  int (*vectors_)[3];  // of each group of rotors
  MovingAxis* moving_;
  int moving_count_ = 0;
  AddedColumn* added_;
  int added_count_ = 0;
  Turn* turns_;
  int turn_count_ = 0;
  CookedPart parts_[kMostColumns / kGroup];
  int part_count_ = 0;
};

}  // namespace mocapress::runtime
