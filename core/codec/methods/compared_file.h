// SPDX-License-Identifier: MIT
// Reads .mcpr files of any method, and writes those of comparison methods (section COMP:
// core/runtime/format/FORMAT.md).
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "core/codec/format/compressed_clip.h"
#include "core/codec/methods/comparison_method.h"

namespace mocapress {

/// Writes the file of a clip compressed by a comparison method. `clip.motion` holds the method's
/// bytes; basis, coding and provenance.method have no meaning.
std::vector<std::byte> write_compared(const ComparisonMethod& method, const CompressedClip& clip);

/// A .mcpr file of any method, read and decoded.
struct OpenedMcpr {
  std::string method;         // a method's name: "annealed", "haar", "pca" ...
  bool of_wavelets = true;    // else basis, coding, provenance.method and seed have no meaning
  CompressedClip compressed;  // its `motion` is what the ratio counts
  Clip decoded;

  std::optional<Coding> coding() const {
    return of_wavelets ? std::optional(compressed.coding) : std::nullopt;
  }
};

/// Throws FormatError.
OpenedMcpr read_mcpr(std::span<const std::byte> bytes);

/// Reads the file without decoding it: `decoded` is left to decode(), or to callers who need only a
/// part.
OpenedMcpr read_coded_mcpr(std::span<const std::byte> bytes);
Clip decode(const OpenedMcpr& opened);

/// Opens and decodes a file. Throws InputError, which names file and byte offset.
OpenedMcpr open_mcpr(const std::filesystem::path& path);

/// The name of the method that made these wavelets: "haar" for standard selection in that basis.
std::string_view wavelet_method_name(const CompressedClip& wavelets);

}  // namespace mocapress
