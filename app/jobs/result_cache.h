// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <list>
#include <string>

#include "app/jobs/clips.h"

namespace mocapress {

struct EncodeSettings;

/// Equal for settings that give the same bytes and measures of the same clip.
std::string settingsKey(const EncodeSettings& options);

/// Finished answers by their settings, so that going back and forth between settings waits for
/// nothing. Those not asked for longest go first when it holds too much.
class ResultCache {
 public:
  static constexpr std::size_t kMostBytes = 256 << 20;

  /// Null: not there.
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

  std::list<Entry> entries_;  // asked for last first
  std::size_t bytes_ = 0;
};

}  // namespace mocapress
