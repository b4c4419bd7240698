// SPDX-License-Identifier: MIT
#include "core/bank/bank_source.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/folder_listing.h"
#include "core/base/path_kind.h"
#include "core/base/utf8_path.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

std::string lower_extension(const fs::path& path) {
  std::string extension = utf8(path.extension());
  std::ranges::transform(extension, extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
  });
  return extension;
}

/// Adds every .mcpr below `folder`. A file that cannot be read is added too, and refused later, so
/// that none is left out silently.
void add_below(const fs::path& folder, const fs::path& top, std::vector<BankSource>& sources) {
  const FolderListing listing = list_folder(folder);
  for (const auto& [path, is_link, kind, problem] : listing.entries) {
    if (kind == PathKind::Folder) {
      if (!is_link) add_below(path, top, sources);
    } else if (lower_extension(path) == ".mcpr") {
      sources.push_back({generic_utf8(path.lexically_relative(top).replace_extension()), path, {}});
    }
  }
  if (!listing.problem.empty()) throw InputError(utf8(folder), 0, 0, listing.problem);
}

void find_below(const fs::path& folder, std::vector<BankSource>& sources) {
  const std::size_t before = sources.size();
  add_below(folder, folder, sources);
  if (sources.size() == before) throw InputError(utf8(folder), 0, 0, "holds no .mcpr file");
}

void take_from(const fs::path& path, std::vector<BankSource>& sources) {
  const BankFile bank(path);
  if (bank.is_cooked())
    throw InputError(utf8(path), 0, 0,
                     "the bank is cooked: clips are taken from packed banks and .mcpr files");
  for (std::uint32_t clip = 0; clip < bank.clips(); ++clip) {
    const std::string name = bank.entry(clip).name;
    sources.push_back({name, path, name});
  }
}

}  // namespace

std::vector<BankSource> find_bank_sources(const std::vector<fs::path>& inputs) {
  std::vector<BankSource> sources;
  for (const fs::path& input : inputs) {
    if (path_kind(input) == PathKind::Folder)
      find_below(input, sources);
    else if (lower_extension(input) == ".mcpk")
      take_from(input, sources);
    else
      sources.push_back({utf8(input.stem()), input, {}});
  }
  return sources;
}

BankSourceReader::BankSourceReader(const std::vector<BankSource>& sources) {
  for (const BankSource& source : sources)
    if (!source.of_bank.empty()) banks_.try_emplace(source.file, source.file);
}

BankSourceReader::File BankSourceReader::read(const BankSource& source) const {
  if (source.of_bank.empty()) return {read_bytes(source.file), {}};
  const BankFile& bank = banks_.at(source.file);
  const std::int64_t clip =
      runtime::find_clip(bank.bank(), source.of_bank.data(), source.of_bank.size());
  if (clip < 0) throw InputError(utf8(source.file), 0, 0, "no clip " + source.of_bank);
  const runtime::BankEntry entry = bank.entry(static_cast<std::uint32_t>(clip));
  return {bank.extract(entry), bank.tags(entry)};
}

}  // namespace mocapress
