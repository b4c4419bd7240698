// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "core/formats/motion_file.h"
#include "core/report/review.h"

namespace mocapress {

/// One clip of a batch.
struct BatchItem {
  std::string input;
  std::string skeleton;    // the .asf; empty: the one beside the .amc
  std::string output;      // path below the batch's folder, without extension
  std::size_t preset = 0;  // index into Batch::presets
  std::string problem;     // why it cannot be done; empty: no problem
  ClipReview review = {};
  std::optional<ReadOptions> reading = {};  // unset: as in Batch::reading

  bool operator==(const BatchItem&) const = default;
};

/// The clips of a batch in packed form. A list of 100,000 takes no more memory than one clip's
/// motion.
class ItemList {
 public:
  ItemList() = default;
  ItemList(std::initializer_list<BatchItem> items);

  void push_back(const BatchItem& item);
  void replace(std::size_t index, const BatchItem& item);
  void erase(std::size_t index);

  /// Frees memory that was reserved for growth.
  void shrink();

  std::size_t size() const { return places_.size(); }
  bool empty() const { return places_.empty(); }
  BatchItem operator[](std::size_t index) const;

  class Iterator {
   public:
    Iterator(const ItemList& list, std::size_t index) : list_(list), index_(index) {}
    BatchItem operator*() const { return list_[index_]; }
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return index_ != other.index_; }

   private:
    const ItemList& list_;
    std::size_t index_;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }

  bool operator==(const ItemList& other) const;

 private:
  struct Place {
    std::size_t offset;          // in text_
    std::uint32_t input_folder;  // indices into folders_
    std::uint32_t output_folder;
  };

  Place append(const BatchItem& item);
  std::uint32_t index_of_folder(const std::string& path);

  // The fields of all items, each ended by a zero: file name of the input, skeleton, last part of
  // the output, preset, problem, the fields of the review, its notes as JSON, and the options for
  // reading.
  std::string text_;
  std::vector<std::string> folders_;  // each ends with a separator, or is empty
  std::vector<Place> places_;
};

}  // namespace mocapress
