// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/runtime/format/memory.h"

namespace mocapress::runtime {

/// Earlier signals that resemble a signal; -1: none.
struct SignalNeighbours {
  int sibling = -1;  // the previous channel of the joint or, for its first, the last one of the
                     // joints above
  int mirror = -1;   // on the other side of the body
};

/// The skeleton as far as neighbours depend on it.
struct JointTree {
  int joints;
  const std::int16_t* parents;  // -1: a root; else an earlier joint
  const std::uint8_t* channel_counts;
};

/// Finds the neighbours of channels from the skeleton alone: FORMAT.md, 6.4. Takes time in
/// proportion to joints^2 at worst.
class NeighbourFinder {
 public:
  NeighbourFinder(Memory& memory, int joints);

  /// `neighbours` has one element per channel.
  void find(const JointTree& tree, SignalNeighbours* neighbours) const;

 private:
  void link_children(const JointTree& tree) const;
  void number_shapes(const JointTree& tree) const;
  bool same_shape(const JointTree& tree, int a, int b) const;
  void find_mirrors(const JointTree& tree) const;

  // Arrays with one element per joint; -1: none.
  int* first_child_;
  int* next_sibling_;
  int* shape_;  // number of the joint's shape. Subtrees with equal numbers are equally large and
                // have the same channels
  int* mirror_;
  int* first_channel_;
  // A hash table from shapes of subtrees to joints.
  std::uint32_t table_size_;  // a power of 2
  int* table_;
};

/// Sets the neighbours of an IK correction's offsets, `count` signals after the first `first`.
void set_correction_neighbours(int first, int count, SignalNeighbours* neighbours);

}  // namespace mocapress::runtime
