// SPDX-License-Identifier: MIT
// The .mcpr files of every method alike. The section COMP: core/runtime/format/FORMAT.md.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "core/codec/format/compressed_clip.h"
#include "core/codec/methods/comparison_method.h"

namespace mocapress {

/// The file of a clip compressed by a comparison method: `clip.motion` has the method's bytes;
/// basis, coding and provenance.method say nothing.
std::vector<std::byte> write_compared(const ComparisonMethod& method, const CompressedClip& clip);

/// A .mcpr file of any method, read and decoded.
struct OpenedMcpr {
  std::string method;         // a method's name: "annealed", "haar", "pca" ...
  bool of_wavelets = true;    // else basis, coding, provenance.method and seed say nothing
  CompressedClip compressed;  // its `motion` is what the ratio counts
  Clip decoded;

  std::optional<Coding> coding() const {
    return of_wavelets ? std::optional(compressed.coding) : std::nullopt;
  }
};

/// Throws FormatError.
OpenedMcpr read_mcpr(std::span<const std::byte> bytes);

/// The same in two steps: `decoded` is left to decode(), or to who wants but a part of it.
OpenedMcpr read_coded_mcpr(std::span<const std::byte> bytes);
Clip decode(const OpenedMcpr& opened);

/// The same from a file. Throws InputError, which names file and byte offset.
OpenedMcpr open_mcpr(const std::filesystem::path& path);

/// The method whose wavelets these are: "haar" for standard selection in that basis.
std::string_view wavelet_method_name(const CompressedClip& wavelets);

}  // namespace mocapress
