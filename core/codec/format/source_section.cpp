// SPDX-License-Identifier: MIT
#include "core/codec/format/source_section.h"

#include "core/base/file.h"
#include "core/base/utf8_path.h"
#include "core/codec/format/container.h"
#include "core/codec/format/format_error.h"
#include "core/codec/format/section_writer.h"

namespace mocapress {
namespace {

constexpr const char* kTag = "srce";
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

SourceFormat read_payload(const runtime::Bytes& payload) {
  runtime::Cursor cursor = payload.cursor();
  const auto kind = cursor.read<std::uint8_t>();
  const auto up = cursor.read<std::uint8_t>();
  const auto root = cursor.read<std::uint8_t>();
  const auto cm_per_unit = cursor.read<double>();
  const auto refuse = [&](const char* what) { throw FormatError(payload.offset, what); };
  if (cursor.failed() || !cursor.at_end()) refuse("srce has the wrong size");
  if (kind < 1 || kind > 4) refuse("unknown kind of source");
  if (up > 1) refuse("unknown axis");
  if (root > kNoConvention) refuse("unknown convention");
  if (!is_possible_unit(cm_per_unit)) refuse("an impossible unit of length");
  SourceFormat source{static_cast<SourceFormat::Kind>(kind)};
  source.up = static_cast<UpAxis>(up);
  if (root != kNoConvention) source.root = static_cast<TranslationConvention>(root);
  source.cm_per_unit = cm_per_unit;
  return source;
}

}  // namespace

std::vector<std::byte> with_source(std::span<const std::byte> mcpr, const SourceFormat& source) {
  std::optional<std::vector<std::byte>> payload;
  if (source.kind != SourceFormat::Kind::None && is_possible_unit(source.cm_per_unit))
    payload = payload_of(source);
  return with_section(mcpr, kTag, payload);
}

SourceFormat source_of(std::span<const std::byte> mcpr) {
  const runtime::FileSections sections = sections_of(mcpr);
  return sections.source.data != nullptr ? read_payload(sections.source) : SourceFormat{};
}

SourceFormat load_source(const std::filesystem::path& mcpr) {
  try {
    return source_of(read_bytes(mcpr));
  } catch (const FormatError& error) {
    throw InputError(utf8(mcpr), 0, 0, error.what());
  }
}

}  // namespace mocapress
