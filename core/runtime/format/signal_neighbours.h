// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/runtime/format/memory.h"

namespace mocapress::runtime {

/// Which signals resemble one another: an earlier signal, or -1 for none.
struct SignalNeighbours {
  int sibling = -1;  // turns the same joint or, for the first of a joint, the one above
  int mirror = -1;   // on the other side of the body
};

/// What the neighbours of channels follow from.
struct JointTree {
  int joints;
  const std::int16_t* parents;  // -1: a root; otherwise before the joint
  const std::uint8_t* channel_counts;
};

/// Finds the neighbours of channels from a skeleton's tree alone: FORMAT.md, 6.4. Works in
/// memory of its own, in time in proportion to joints^2 at worst.
class NeighbourFinder {
 public:
  NeighbourFinder(Memory& memory, int joints);

  /// `neighbours`: one for each channel.
  void find(const JointTree& tree, SignalNeighbours* neighbours) const;

 private:
  void link_children(const JointTree& tree) const;
  void number_shapes(const JointTree& tree) const;
  bool same_shape(const JointTree& tree, int a, int b) const;
  void find_mirrors(const JointTree& tree) const;

  // Of each joint; -1: none.
  int* first_child_;
  int* next_sibling_;
  int* shape_;  // subtrees of the same number are as large and have the same channels
  int* mirror_;
  int* first_channel_;
  // A hash table of joints by the shape of what is below them.
  std::uint32_t table_size_;  // a power of 2
  int* table_;
};

/// The same for the differences of an IK correction, which follow `first` channels.
void set_correction_neighbours(int first, int count, SignalNeighbours* neighbours);

}  // namespace mocapress::runtime
