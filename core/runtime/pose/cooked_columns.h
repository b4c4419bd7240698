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

/// Assigns a clip's channels to columns. Finds the channels that change, gives them columns where
/// the kernels for eight joints read them, and lists how columns make poses.
class CookedColumns {
 public:
  struct Channel {
    double factor = 1;    // from the channel's value to the column's: 1/2 for angles
    double constant = 0;  // the value, if it never changes
    double least = 0;  // this and the next: range of the samples, reconstructed without the bands
                       // that may be kept
    double most = 0;
    double furthest = 0;  // for angles: largest magnitude at any frame, end corrections included
    std::int32_t largest[kMostKeptBands] = {};  // for each of the finest bands: largest magnitude
                                                // of a coefficient, in steps
    double reach[kMostKeptBands] = {};  // the same in cm or in quarter radians, whose errors have
                                        // the same limit
    std::uint16_t joint = 0;
    std::uint8_t kind = 0;
    bool changes = false;
    bool is_wide = false;
    std::int32_t column = -1;
  };
  /// A joint in a RotorGroup, with its channels that turn it about up to three axes.
  struct Rotor {
    std::uint16_t joint = 0;
    std::uint8_t angles = 0;
    std::uint8_t are_near = 7;  // one bit per angle that stays within a quarter of a turn
    std::uint16_t channel[3] = {};

    /// Number of angles whose bit in are_near is 0.
    int far() const { return 3 - std::popcount(are_near); }
  };
  struct Column {
    std::int32_t channel = -1;  // -1: none
    double base = 0;            // value added to all samples
    double factor = 1;
    bool is_free = false;  // true: the column can be given to any channel
  };
  struct Turn {
    OtherTurn made;
    std::int32_t channel = -1;  // channel of the angle; -1: a constant rotation
    bool is_after = false;  // true: the constant rotation after the angles; false: the one before
  };

  /// Range for the number of detail bands.
  struct BandRange {
    int fewest = 4;
    int most = 5;
  };

  /// If `memory` only measures, this counts bytes and does nothing else.
  CookedColumns(Memory& memory, const ClipBlock& clip, CookedCoefficients& coefficients,
                BandRange bands);

  /// Analyses each channel, and assigns the columns.
  mcpr_result place();

  BandRange bands() const { return bands_; }
  /// Sets the number of detail bands in parts that are not wide.
  void keep_bands(int bands);

  int groups() const { return groups_; }
  /// Number of groups with rows. The other groups copy values from these.
  int row_groups() const { return row_groups_; }
  const Channel& channel(int number) const { return channels_[number]; }
  const Column& column(int number) const { return columns_[number]; }
  std::span<const Rotor> rotors() const { return span_of(rotors_, rotor_count_); }
  /// The groups of columns with the angles of a rotor group.
  const int (&vectors(int rotor_group) const)[3] { return vectors_[rotor_group]; }
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
  bool is_narrow(int group, bool wide) const;
  void add_parts(int first, int end, bool wide);
  int new_group();
  std::int32_t place(int channel);
  void place_joint(int joint);
  void note_columns();
  void list_moving();

  static constexpr std::int32_t kMostValue = 2047;  // largest coefficient of a detail band; bands
                                                    // with larger ones become samples
  static constexpr double kMostRange = 3.9;  // largest range of 16-bit samples, in radians or cm
  // Largest quantisation step of samples with four bits less. A half angle is then off by at most
  // half a step, and a joint by a whole step about each of up to three axes.
  static constexpr double kMostTurn = 1.5e-4;  // radians, of half angles
  static constexpr double kMostShift = 1e-3;   // cm
  // Largest coefficient of a detail band in cm or quarter radians. 16-bit weights are off by up to
  // 1.5e-5, and several coefficients contribute to a sample.
  static constexpr double kMostReach = 20;

  const ClipBlock& clip_;
  CookedCoefficients& coefficients_;
  const BandRange bands_;
  int wide_bands_;
  Channel* channels_;
  Rotor* rotors_;
  int rotor_count_ = 0;
  Column* columns_;
  int groups_ = 0;
  int normal_groups_ = 0;
  int row_groups_ = 0;
  int (*vectors_)[3];  // one per group of rotors
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
