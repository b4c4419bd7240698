// SPDX-License-Identifier: MIT
#include "core/runtime/format/signal_neighbours.h"

#include <algorithm>
#include <bit>

namespace mocapress::runtime {

NeighbourFinder::NeighbourFinder(Memory& memory, int joints) {
  const auto count = static_cast<std::uint32_t>(joints);
  first_child_ = memory.take<int>(count);
  next_sibling_ = memory.take<int>(count);
  shape_ = memory.take<int>(count);
  mirror_ = memory.take<int>(count);
  first_channel_ = memory.take<int>(count);
  table_size_ = std::bit_ceil(2 * count + 1);
  table_ = memory.take<int>(table_size_);
}

void NeighbourFinder::link_children(const JointTree& tree) const {
  std::fill_n(first_child_, tree.joints, -1);
  for (int j = tree.joints - 1; j >= 0; --j) {
    const int parent = tree.parents[j];
    next_sibling_[j] = parent < 0 ? -1 : first_child_[parent];
    if (parent >= 0) first_child_[parent] = j;
  }
}

bool NeighbourFinder::same_shape(const JointTree& tree, int a, int b) const {
  if (tree.channel_counts[a] != tree.channel_counts[b]) return false;
  int of_a = first_child_[a];
  int of_b = first_child_[b];
  for (; of_a >= 0 && of_b >= 0; of_a = next_sibling_[of_a], of_b = next_sibling_[of_b])
    if (shape_[of_a] != shape_[of_b]) return false;
  return of_a == of_b;
}

/// Numbers the subtrees by shape, children first. Subtrees of equal shape get the same number: the
/// joint that was found first.
void NeighbourFinder::number_shapes(const JointTree& tree) const {
  std::fill_n(table_, table_size_, -1);
  for (int j = tree.joints - 1; j >= 0; --j) {
    std::uint32_t hash = tree.channel_counts[j];
    for (int child = first_child_[j]; child >= 0; child = next_sibling_[child])
      hash = (hash ^ static_cast<std::uint32_t>(shape_[child] + 1)) * 0x9E3779B1U;
    std::uint32_t slot = (hash ^ hash >> 15) & (table_size_ - 1);
    while (table_[slot] >= 0 && !same_shape(tree, table_[slot], j))
      slot = (slot + 1) & (table_size_ - 1);
    if (table_[slot] < 0) {
      table_[slot] = j;
      shape_[j] = j;
    } else {
      shape_[j] = shape_[table_[slot]];
    }
  }
}

/// Finds the mirror of each joint. If the parent mirrors another joint, the mirror is that joint's
/// child at the same place among its children. Otherwise it is the last earlier sibling of the same
/// shape that has no mirror.
void NeighbourFinder::find_mirrors(const JointTree& tree) const {
  std::fill_n(mirror_, tree.joints, -1);
  for (int parent = 0; parent < tree.joints; ++parent) {
    const int like_parent = mirror_[parent];
    int other = like_parent >= 0 ? first_child_[like_parent] : -1;
    for (int j = first_child_[parent]; j >= 0; j = next_sibling_[j]) {
      if (like_parent >= 0) {
        if (other >= 0 && other < j) mirror_[j] = other;
        if (other >= 0) other = next_sibling_[other];
        continue;
      }
      for (int k = first_child_[parent]; k != j; k = next_sibling_[k])
        if (shape_[k] == shape_[j] && mirror_[k] < 0) mirror_[j] = k;
    }
  }
}

void NeighbourFinder::find(const JointTree& tree, SignalNeighbours* neighbours) const {
  link_children(tree);
  number_shapes(tree);
  find_mirrors(tree);
  int channel = 0;
  int* const last_of = first_child_;  // last channel at or above each joint; uses the memory of
                                      // first_child_, which is no longer needed
  for (int j = 0; j < tree.joints; ++j) {
    first_channel_[j] = channel;
    int last = tree.parents[j] < 0 ? -1 : last_of[tree.parents[j]];
    for (int i = 0; i < tree.channel_counts[j]; ++i, ++channel) {
      neighbours[channel] = {last, mirror_[j] < 0 ? -1 : first_channel_[mirror_[j]] + i};
      last = channel;
    }
    last_of[j] = last;
  }
}

void set_correction_neighbours(int first, int count, SignalNeighbours* neighbours) {
  for (int s = 0; s < count; ++s)
    neighbours[s] = {s % 3 == 0 ? -1 : first + s - 1, s < 3 ? -1 : first + s - 3};
}

}  // namespace mocapress::runtime
