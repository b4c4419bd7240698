// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/runtime/format/memory.h"

namespace mocapress::runtime {

/// Earlier signals that resemble a signal; -1: none.
struct SignalNeighbours {
  int sibling = -1;  // the joint's previous channel; for its first channel, the last channel of the
                     // joints above
  int mirror = -1;   // the same channel on the other side of the body
};

/// The properties of the skeleton from which neighbours are found.
struct JointTree {
  int joints;
  const std::int16_t* parents;  // -1: a root; else an earlier joint
  const std::uint8_t* channel_counts;
};

/// Finds the neighbours of channels from the skeleton alone: FORMAT.md, 6.4. In the worst case, the
/// time grows as joints^2.
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
  int* shape_;  // number of the joint's shape: subtrees with the same number have equal structure
                // and channels
  int* mirror_;
  int* first_channel_;
  // A hash table from the shapes of subtrees to joints.
  std::uint32_t table_size_;  // a power of 2
  int* table_;
};

/// Sets the neighbours of an IK correction's offsets: `count` signals, the first of which has
/// number `first`.
void set_correction_neighbours(int first, int count, SignalNeighbours* neighbours);

}  // namespace mocapress::runtime
