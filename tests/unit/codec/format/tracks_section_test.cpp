// SPDX-License-Identifier: MIT
#include "core/codec/format/tracks_section.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/codec/format/container.h"
#include "core/codec/format/source_section.h"
#include "tests/fuzz/file_sections.h"
#include "tests/support/segmented_clip.h"
#include "tests/support/some_tracks.h"
#include "tests/support/test_motion.h"

namespace mocapress::tracks_section_test {
namespace {

using Bytes = std::vector<std::byte>;

constexpr int kTrackFrames = 40;

Bytes clip_without_tracks() {
  return write_container(
      test::segmented_clip(test::smooth_motion(kTrackFrames), SegmentLayout::whole(kTrackFrames)));
}

CodedTracks some_coded() {
  return test::some_coded_tracks(kTrackFrames);
}

void expect_same_tracks(const CodedTracks& found, const CodedTracks& wanted) {
  EXPECT_EQ(found.tracks, wanted.tracks);
  EXPECT_EQ(found.is_curve, wanted.is_curve);
  EXPECT_EQ(found.basis, wanted.basis);
  EXPECT_EQ(found.curves.scale, wanted.curves.scale);
  EXPECT_EQ(found.curves.step_exponent, wanted.curves.step_exponent);
  EXPECT_EQ(found.curves.values, wanted.curves.values);
}

TEST(TracksSection, ComesBackAsItWasWritten) {
  expect_same_tracks(coded_tracks_of(with_coded_tracks(clip_without_tracks(), some_coded())),
                     some_coded());
}

TEST(TracksSection, ChangesNothingElse) {
  const Bytes plain = clip_without_tracks();
  const Bytes with = with_coded_tracks(plain, some_coded());
  EXPECT_EQ(with_coded_tracks(with, {}), plain);
  EXPECT_EQ(with_coded_tracks(with, some_coded()), with);
  EXPECT_TRUE(std::equal(plain.begin() + 8, plain.end(), with.begin() + 8));
  EXPECT_EQ(with.size(), plain.size() + track_bytes_of(with));
  EXPECT_EQ(track_bytes_of(plain), 0u);
  EXPECT_TRUE(coded_tracks_of(plain).tracks.empty());
  // A source that is written later leaves them alone.
  expect_same_tracks(coded_tracks_of(with_source(with, {.kind = SourceFormat::Kind::Gltf})),
                     some_coded());
}

TEST(TracksSection, HoldsEveryFloatBitForBit) {
  Random random(7);
  ScalarTrack track{.name = "anything", .values = {0.0F, -0.0F, 1e-40F, -3.4e38F}};
  while (track.values.size() < kTrackFrames) {
    const auto bits = static_cast<std::uint32_t>(random.below(1U << 31)) << 1;
    const float value = std::bit_cast<float>(bits);
    track.values.push_back(std::isfinite(value) ? value : 1.0F);
  }
  const CodedTracks coded{{track}, {false}, Basis::Cubic, {}};
  const ScalarTracks found =
      coded_tracks_of(with_coded_tracks(clip_without_tracks(), coded)).tracks;
  for (std::size_t t = 0; t < track.values.size(); ++t)
    EXPECT_EQ(std::bit_cast<std::uint32_t>(found[0].values[t]),
              std::bit_cast<std::uint32_t>(track.values[t]));
}

TEST(TracksSection, NearlyConstantTracksCostNextToNothing) {
  CodedTracks coded;
  for (int t = 0; t < 100; ++t) {
    ScalarTrack track{
        .kind = TrackKind::MorphWeight, .node = "Face", .name = "m" + std::to_string(t)};
    track.values.assign(kTrackFrames, 0.0F);
    coded.tracks.push_back(track);
    coded.is_curve.push_back(false);
  }
  const std::size_t still =
      with_coded_tracks(clip_without_tracks(), coded).size() - clip_without_tracks().size();
  EXPECT_LT(still, 400u) << "names and all";
  for (int t = 0; t < 100; ++t)  // shown, hidden, shown
    std::fill_n(coded.tracks[static_cast<std::size_t>(t)].values.begin() + 10, 20 - t % 3, 1.0F);
  const std::size_t switched =
      with_coded_tracks(clip_without_tracks(), coded).size() - clip_without_tracks().size();
  EXPECT_LT(switched, still + 100 * 4);
}

TEST(TracksSection, RefusesTracksThatNoFileCanHold) {
  const auto refusal = [](CodedTracks coded) -> std::string {
    try {
      with_coded_tracks(clip_without_tracks(), coded);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  CodedTracks coded = some_coded();
  coded.tracks[0].values[3] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refusal(coded), "its tracks cannot be kept: visible has a value that is not finite");
  coded = some_coded();
  coded.tracks[0].values.pop_back();
  EXPECT_EQ(refusal(coded),
            "its tracks cannot be kept: visible has another number of frames than the clip");
  coded = some_coded();
  coded.tracks[0].node = std::string(256, 'x');
  EXPECT_EQ(refusal(coded), "its tracks cannot be kept: the name of one has more than 255 bytes");
  coded.tracks.resize(4097);
  EXPECT_EQ(refusal(coded), "its tracks cannot be kept: there are 4097, at most 4096 are possible");
}

/// The tracks' section with these bytes, behind a right checksum.
Bytes with_tracks_payload(std::span<const std::byte> payload) {
  Bytes file = with_coded_tracks(clip_without_tracks(), some_coded());
  const std::size_t begin = clip_without_tracks().size();
  file.resize(begin + 12);
  const auto size = static_cast<std::uint32_t>(payload.size());
  std::memcpy(file.data() + begin + 4, &size, 4);
  file.insert(file.end(), payload.begin(), payload.end());
  test::mend_checksums(file);
  return file;
}

Bytes tracks_payload() {
  const Bytes file = with_coded_tracks(clip_without_tracks(), some_coded());
  return {file.begin() + static_cast<long>(clip_without_tracks().size() + 12), file.end()};
}

TEST(TracksSection, EveryTruncationIsRefused) {
  const Bytes file = with_coded_tracks(clip_without_tracks(), some_coded());
  for (std::size_t size = clip_without_tracks().size(); size < file.size(); ++size)
    EXPECT_THROW(coded_tracks_of(std::span(file).first(size)), FormatError) << size;
  // Behind right sizes and checksums too, but for the last bytes, which hardly say anything.
  const Bytes whole = tracks_payload();
  expect_same_tracks(coded_tracks_of(with_tracks_payload(whole)), some_coded());
  for (std::size_t size = 0; size + 4 < whole.size(); ++size)
    EXPECT_THROW(coded_tracks_of(with_tracks_payload(std::span(whole).first(size))), FormatError)
        << size;
}

TEST(TracksSection, EveryChangedByteIsRefusedOrReads) {
  const Bytes whole = tracks_payload();
  Random random(3);
  int refused = 0;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    Bytes changed = whole;
    changed[at] ^= static_cast<std::byte>(1 + random.below(255));
    try {
      const CodedTracks found = coded_tracks_of(with_tracks_payload(changed));
      for (std::size_t t = 0; t < found.tracks.size(); ++t)
        EXPECT_EQ(found.tracks[t].values.size(), found.is_curve[t] ? 0u : kTrackFrames);
    } catch (const FormatError& error) {
      ++refused;
    }
  }
  EXPECT_GT(refused, static_cast<int>(whole.size()) / 4);
}

}  // namespace
}  // namespace mocapress::tracks_section_test
