// SPDX-License-Identifier: MIT
#include "core/batch/item_list.h"

namespace mocapress {

ItemList::ItemList(std::initializer_list<BatchItem> items) {
  for (const BatchItem& item : items) push_back(item);
}

/// No file name holds a 0, and a problem that does is cut there.
std::size_t ItemList::append(const BatchItem& item) {
  const std::size_t offset = text_.size();
  for (const std::string& field :
       {item.input, item.skeleton, item.output, std::to_string(item.preset), item.problem}) {
    text_ += field.c_str();
    text_ += '\0';
  }
  return offset;
}

void ItemList::push_back(const BatchItem& item) {
  offsets_.push_back(append(item));
}

/// What was there stays behind: few are replaced.
void ItemList::replace(std::size_t index, const BatchItem& item) {
  offsets_[index] = append(item);
}

void ItemList::erase(std::size_t index) {
  offsets_.erase(offsets_.begin() + static_cast<std::ptrdiff_t>(index));
}

void ItemList::shrink() {
  text_.shrink_to_fit();
  offsets_.shrink_to_fit();
}

BatchItem ItemList::operator[](std::size_t index) const {
  const char* at = text_.data() + offsets_[index];
  const auto next = [&at] {
    const std::string field(at);
    at += field.size() + 1;
    return field;
  };
  BatchItem item;
  item.input = next();
  item.skeleton = next();
  item.output = next();
  item.preset = std::stoul(next());
  item.problem = next();
  return item;
}

bool ItemList::operator==(const ItemList& other) const {
  if (size() != other.size()) return false;
  for (std::size_t i = 0; i < size(); ++i)
    if ((*this)[i] != other[i]) return false;
  return true;
}

}  // namespace mocapress
