// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/result_cache.h"

#include <algorithm>
#include <limits>
#include <locale>
#include <sstream>

#include "core/codec/encode/encoder.h"

namespace mocapress {

std::string settingsKey(const EncodeSettings& options) {
  std::ostringstream key;
  key.imbue(std::locale::classic());
  key.precision(std::numeric_limits<double>::max_digits10);
  key << static_cast<int>(options.method) << ' ' << static_cast<int>(effective_coding(options))
      << ' ' << static_cast<int>(options.basis) << ' ' << static_cast<int>(options.weighting) << ' '
      << static_cast<int>(options.target.kind) << ' ' << options.target.value << ' ' << options.seed
      << ' ' << static_cast<int>(options.effort) << ' ' << static_cast<int>(options.ends);
  if (options.loop) key << " loop " << static_cast<int>(*options.loop);
  if (!options.importance.is_even()) {
    key << " importance " << options.importance.contacts;
    for (const double factor : options.importance.joints) key << ' ' << factor;
  }
  for (const PromiseKey& promise : kPromiseKeys)
    key << ' ' << (options.promises.*promise.bound).value_or(0);
  if (options.limits != SightLimits()) {
    key << " limits " << options.limits.distance_m;
    for (const CueLimit& limit : options.limits.of_cues)
      key << ' ' << limit.least << ' ' << limit.share;
  }
  if (const auto& correction = options.correction) {
    key << " ik " << static_cast<int>(correction->solver) << ' ' << static_cast<int>(correction->at)
        << ' ' << correction->ratio.value_or(0);
    for (const int joint : correction->joints) key << ' ' << joint;
  }
  for (const ImportantRange& range : options.ranges)
    key << " range " << range.first_frame << ' ' << range.last_frame << ' ' << range.factor;
  if (options.contacts) {
    key << " contacts";
    for (const ContactSpan& span : *options.contacts)
      key << ' ' << span.landmark << ' ' << span.first_frame << ' ' << span.last_frame;
  }
  return key.str();
}

std::string bytesKey(const EncodeSettings& options) {
  if (options.target.kind == Target::Kind::Visibility) return settingsKey(options);
  EncodeSettings shaping = options;
  shaping.limits = {};
  return settingsKey(shaping);
}

namespace {

template <typename Matrix>
std::size_t bytesOf(const Matrix& matrix) {
  return static_cast<std::size_t>(matrix.size()) * sizeof(typename Matrix::Scalar);
}

/// Approximate size: counts the file and the arrays with a value for each frame, which dominate.
std::size_t bytesOf(const DecodedClip& decoded) {
  std::size_t bytes = decoded.file.size() + bytesOf(decoded.clip.channels);
  for (const Tracks& tracks : {decoded.tracks, decoded.uncorrected_tracks})
    if (tracks) bytes += bytesOf(*tracks);
  if (decoded.correction) bytes += bytesOf(decoded.correction->uncorrected.channels);
  if (decoded.distortion)
    bytes += bytesOf(decoded.distortion->distances) + bytesOf(decoded.distortion->turns);
  return bytes;
}

}  // namespace

DecodedPtr ResultCache::find(const std::string& key) {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& entry) { return entry.key == key; });
  if (found == entries_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found);
  return found->decoded;
}

void ResultCache::add(const std::string& key, DecodedPtr decoded) {
  if (find(key)) {
    bytes_ -= entries_.front().bytes;
    entries_.pop_front();
  }
  const std::size_t bytes = bytesOf(*decoded);
  entries_.push_front({key, std::move(decoded), bytes});
  bytes_ += bytes;
  while (bytes_ > kMostBytes && entries_.size() > 1) {
    bytes_ -= entries_.back().bytes;
    entries_.pop_back();
  }
}

void ResultCache::clear() {
  entries_.clear();
  bytes_ = 0;
}

}  // namespace mocapress
