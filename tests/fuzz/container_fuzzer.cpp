// SPDX-License-Identifier: MIT
// Opens and decodes any bytes as a .mcpr file with core's reader, or sees them refused.
#include <cstdlib>

#include "core/base/error.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/decode/track_decoding.h"
#include "core/codec/format/container.h"
#include "core/codec/format/source_section.h"
#include "tests/fuzz/file_sections.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr Eigen::Index kMostValues = 1 << 16;  // keeps runs short
  std::vector<std::byte> file(size);
  if (size > 0) std::memcpy(file.data(), data, size);
  mocapress::test::mend_checksums(file);
  try {
    const mocapress::Container container = mocapress::read_any_container(file);
    // Writing the source again gives the same section.
    const mocapress::SourceFormat source = mocapress::source_of(file);
    if (mocapress::source_of(mocapress::with_source(file, source)) != source) std::abort();
    const mocapress::CompressedClip& clip = container.clip;
    if (container.of_comparison ||
        Eigen::Index{clip.frames} * (clip.skeleton.channel_count() + 96) > kMostValues)
      return 0;
    mocapress::decode(clip);
    const mocapress::CodedTracks tracks = mocapress::coded_tracks_of(file);
    if (tracks.curves.values.size() > kMostValues) return 0;
    mocapress::decode_tracks(tracks);
    // The tracks of any file can be written, even if its own bytes differ.
    if (mocapress::coded_tracks_of(mocapress::with_coded_tracks(file, tracks)).tracks !=
        tracks.tracks)
      std::abort();
  } catch (const mocapress::FormatError&) {
  }
  return 0;
}
