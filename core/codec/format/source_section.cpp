// SPDX-License-Identifier: MIT
#include "core/codec/format/source_section.h"

#include <cmath>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/codec/format/section.h"

namespace mocapress {
namespace {

constexpr std::string_view kTag = "srce";
constexpr std::size_t kHead = 6;        // magic and version
constexpr double kSmallestUnit = 1e-9;  // cm
constexpr double kLargestUnit = 1e9;
constexpr std::uint8_t kNoConvention = 2;

bool is_possible_unit(double cm) {
  return cm >= kSmallestUnit && cm <= kLargestUnit;
}

std::vector<std::byte> payload_of(const SourceFormat& source) {
  ByteWriter writer;
  writer.write(static_cast<std::uint8_t>(source.kind));
  writer.write(static_cast<std::uint8_t>(source.up));
  writer.write(source.root ? static_cast<std::uint8_t>(*source.root) : kNoConvention);
  writer.write(source.cm_per_unit);
  return writer.release();
}

SourceFormat read_payload(const Section& section) {
  ByteReader reader(section.payload, section.payload_offset);
  const auto value = [&](std::uint8_t first, std::uint8_t last, const char* what) {
    const auto read = reader.read<std::uint8_t>();
    if (read < first || read > last) reader.fail("unknown " + std::string(what));
    return read;
  };
  SourceFormat source;
  source.kind = static_cast<SourceFormat::Kind>(value(1, 2, "kind of source"));
  source.up = static_cast<UpAxis>(value(0, 1, "axis"));
  if (const std::uint8_t root = value(0, kNoConvention, "convention"); root != kNoConvention)
    source.root = static_cast<TranslationConvention>(root);
  source.cm_per_unit = reader.read<double>();
  if (!is_possible_unit(source.cm_per_unit)) reader.fail("an impossible unit of length");
  reader.expect_end();
  return source;
}

/// After the file's head.
std::vector<Section> sections_of(ByteReader& file) {
  std::vector<Section> sections;
  for (int left = file.read<std::uint16_t>(); left > 0; --left)
    sections.push_back(read_section(file));
  file.expect_end();
  return sections;
}

}  // namespace

std::vector<std::byte> with_source(std::span<const std::byte> mcpr, const SourceFormat& source) {
  ByteReader reader(mcpr);
  ByteWriter file;
  file.append(reader.take(kHead));
  std::vector<Section> sections = sections_of(reader);
  std::erase_if(sections, [](const Section& section) { return section.tag == kTag; });
  const bool named =
      source.kind != SourceFormat::Kind::None && is_possible_unit(source.cm_per_unit);
  file.write(static_cast<std::uint16_t>(sections.size() + (named ? 1 : 0)));
  for (const Section& section : sections) write_section(file, section.tag, section.payload);
  if (named) write_section(file, kTag, payload_of(source));
  return file.release();
}

SourceFormat source_of(std::span<const std::byte> mcpr) {
  ByteReader file(mcpr);
  file.take(kHead);
  for (const Section& section : sections_of(file))
    if (section.tag == kTag) return read_payload(section);
  return {};
}

SourceFormat load_source(const std::filesystem::path& mcpr) {
  try {
    return source_of(read_bytes(mcpr));
  } catch (const FormatError& error) {
    throw InputError(mcpr.string(), 0, 0, error.what());
  }
}

}  // namespace mocapress
