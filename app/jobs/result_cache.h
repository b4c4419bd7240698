// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <list>
#include <string>

#include "app/jobs/clips.h"

namespace mocapress {

struct EncodeSettings;

/// A key that is equal for settings which give a clip the same bytes and measures.
std::string settingsKey(const EncodeSettings& options);

/// A key that is equal for settings which give a clip the same bytes. They may differ in limits of
/// visibility, unless these are the target.
std::string bytesKey(const EncodeSettings& options);

/// Final answers by clip and bytesKey() of the settings, so that returning to an earlier clip or to
/// earlier settings takes no time. When it holds too much, it drops the least recently used.
class ResultCache {
 public:
  static constexpr std::size_t kMostBytes = 256 << 20;

  /// Null if absent.
  DecodedPtr find(const std::string& key);
  void add(const std::string& key, DecodedPtr decoded);
  void clear();

  std::size_t size() const { return entries_.size(); }
  std::size_t bytes() const { return bytes_; }

 private:
  struct Entry {
    std::string key;
    DecodedPtr decoded;
    std::size_t bytes;
  };

  std::list<Entry> entries_;  // most recently used first
  std::size_t bytes_ = 0;
};

}  // namespace mocapress
