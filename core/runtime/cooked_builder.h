// SPDX-License-Identifier: MIT
// From the resident form of a clip to the cooked one. The coefficients are taken over as they are,
// but for the coarse bands, of which samples are made, and for angles that an IK correction turns,
// whose samples are transformed anew.
#pragma once

#include "core/codec/format/joint_model.h"
#include "core/codec/format/memory.h"
#include "core/runtime/clip.h"
#include "core/runtime/cooked_clip.h"

namespace mocapress::runtime {

class CookedBuilder {
 public:
  /// With measuring memory only to know how much.
  CookedBuilder(Memory& memory, const mcpr_clip& clip, bool apply_ik);

  /// Finds out what each channel needs, and which columns there will be.
  mcpr_result prepare();

  /// Makes the clip, after prepare(), in zeroed memory; without memory only its size.
  std::uint64_t lay_out(std::byte* memory);

 private:
  struct Channel {
    double factor = 1;    // of its values in columns: 1/2 for angles
    double constant = 0;  // its value where it has but one
    double least = 0;     // of its samples after the bands that would be kept
    double most = 0;
    std::int32_t largest[kMostKeptBands] = {};  // magnitude in each of the finest bands
    std::uint16_t joint = 0;
    std::uint8_t kind = 0;
    bool changes = false;
    bool is_corrected = false;  // by IK
    bool is_wide = false;
    std::int32_t column = -1;
  };
  /// A joint in a RotorGroup: its channels, of up to three axes.
  struct Rotor {
    std::uint16_t joint = 0;
    std::uint8_t angles = 0;
    std::uint16_t channel[3] = {};
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
  class Block;

  int channel_count() const { return static_cast<int>(clip_.channel_count); }
  void load(int segment);
  void decode_corrected();
  void fit_corrected(int channel, int segment);
  void find_samples(int channel, int left_out, double* out) const;
  void analyse_segment(int segment);
  void choose_wide();
  void fill_wide();
  mcpr_result place_columns();
  void choose_bands();
  bool place_full_vectors();
  bool place_others(bool wide);
  bool place_gathered_vectors();
  int new_group();
  std::int32_t place(int channel);
  void place_joint(int joint);

  void lay_out_joints(Block& block, mcpr_cooked& head);
  void lay_out_rotors(Block& block, mcpr_cooked& head);
  void lay_out_segment(Block& block, mcpr_cooked& head, int segment);
  CookedRows lay_out_part(Block& block, const CookedPart& part);
  std::uint32_t lay_out_samples(Block& block, const CookedPart& part, int kept);
  CookedBand lay_out_band(Block& block, const CookedPart& part, int depth);
  void put_dense(std::byte* rows, const CookedPart& part, RowKind kind, int depth) const;
  std::uint64_t put_entries(std::byte* memory, const CookedPart& part, const CookedBand& band,
                            int depth) const;
  std::int32_t value(int column, int depth, int row) const;
  int rows_of(int depth) const { return bands_[bands_.count - depth].size; }

  static constexpr int kFewestBands = 4;  // of details that are kept, and most
  static constexpr int kMostBands = 5;
  static constexpr std::int32_t kMostValue = 2047;  // of a kept coefficient; more goes into samples
  static constexpr double kMostRange = 3.9;         // of 16-bit samples, radians or cm
  static constexpr double kFineStep = 0x1p-14;      // radians, of corrected angles

  const ClipBlock& clip_;
  bool apply_ik_;
  int wide_bands_ = kFewestBands;
  Channel* channels_;
  Rotor* rotors_;
  int rotor_count_ = 0;
  Column* columns_;
  int groups_ = 0;
  int normal_groups_ = 0;
  int row_groups_ = 0;  // with the wide ones; others get their values from these
  int (*vectors_)[3];   // of each group of rotors
  MovingAxis* moving_;
  int moving_count_ = 0;
  AddedColumn* added_;
  int added_count_ = 0;
  Turn* turns_;
  int turn_count_ = 0;
  CookedPart parts_[kMostColumns / kGroup];
  int part_count_ = 0;
  // Of the segment that is loaded:
  int loaded_ = -1;
  Bands bands_;
  std::int32_t* values_;  // channel after channel
  double* steps_;
  double* rows_;  // to unpack into
  std::int32_t* in_order_;
  double* line_;
  double* other_line_;
  double* samples_;
  float* corrected_ = nullptr;  // frames x channels
  std::byte* decoding_ = nullptr;
  std::uint64_t decoding_bytes_ = 0;
};

}  // namespace mocapress::runtime
