// SPDX-License-Identifier: MIT
#include "core/bank/bank.h"

#include <algorithm>
#include <map>
#include <memory>
#include <optional>

#include "core/bank/cooked_tables.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/codec/format/packed_clip_writer.h"
#include "core/runtime/bank_check.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

std::string lower_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
  });
  return extension;
}

void find_below(const fs::path& folder, std::vector<BankSource>& sources) {
  const std::size_t before = sources.size();
  std::error_code error;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && at != fs::recursive_directory_iterator(); at.increment(error))
    if (at->is_regular_file() && lower_extension(at->path()) == ".mcpr")
      sources.push_back({at->path().lexically_relative(folder).replace_extension().generic_string(),
                         at->path(),
                         {}});
  if (error) throw InputError(folder.string(), 0, 0, error.message());
  if (sources.size() == before) throw InputError(folder.string(), 0, 0, "holds no .mcpr file");
}

void take_from(const fs::path& path, std::vector<BankSource>& sources) {
  const BankFile bank(path);
  if (bank.is_cooked())
    throw InputError(path.string(), 0, 0,
                     "the bank is cooked: clips are taken from packed banks and .mcpr files");
  for (std::uint32_t clip = 0; clip < bank.clips(); ++clip) {
    const std::string name = bank.entry(clip).name;
    sources.push_back({name, path, name});
  }
}

/// Puts clips into a new bank, wherever they come from.
class Filler {
 public:
  Filler(BankWriter& writer, runtime::BankForm form) : writer_(writer), form_(form) {}

  void put(const BankSource& source, const std::vector<std::string>& tags) {
    if (source.of_bank.empty())
      return put_file(source.name, source.file.string(), read_bytes(source.file), tags);
    BankFile& bank = opened(source.file);
    const std::int64_t clip =
        runtime::find_clip(bank.bank(), source.of_bank.data(), source.of_bank.size());
    if (clip < 0) throw InputError(source.file.string(), 0, 0, "no clip " + source.of_bank);
    const runtime::BankEntry entry = bank.entry(static_cast<std::uint32_t>(clip));
    std::vector<std::string> all = bank.tags(entry);
    all.insert(all.end(), tags.begin(), tags.end());
    put_file(source.name, source.file.string(), bank.extract(entry), all);
  }

  /// A clip as it is in a bank of the same form.
  void copy(const BankFile& bank, const runtime::BankEntry& entry) {
    const std::vector<std::string> tags = bank.tags(entry);
    if (!bank.is_cooked()) {
      const auto* const first =
          reinterpret_cast<const std::byte*>(bank.bank().at(entry.place.offset));
      writer_.add(entry.name, copy_outline(bank.bank(), entry.kind, intern_),
                  {first, static_cast<std::size_t>(entry.place.bytes)}, tags);
      return;
    }
    const mcpr_cooked* cooked = nullptr;
    if (runtime::failed(runtime::cooked_clip_of(bank.bank(), entry, cooked))) return;
    const runtime::Bytes skeleton = bank.bank().item(runtime::BankItem::Part, entry.kind);
    put_cooked(
        entry.name,
        copy_to_bank(*cooked, {reinterpret_cast<const std::byte*>(skeleton.data), skeleton.size},
                     writer_.tables()),
        tags);
  }

 private:
  BankFile& opened(const fs::path& path) {
    if (!bank_ || bank_path_ != path) {
      bank_.emplace(path);
      bank_path_ = path;
    }
    return *bank_;
  }

  void put_file(const std::string& name, const std::string& file,
                const std::vector<std::byte>& bytes, const std::vector<std::string>& tags) try {
    if (form_ == runtime::BankForm::Cooked)
      return put_cooked(name, cook_for_bank(bytes, writer_.tables()), tags);
    const PackedClip packed = pack_clip(bytes, intern_);
    writer_.add(name, packed.outline, packed.bytes, tags);
  } catch (const FormatError& error) {
    throw InputError(file, 0, 0, error.what());
  }

  void put_cooked(const std::string& name, const BankedClip& clip,
                  const std::vector<std::string>& tags) {
    writer_.add(name, writer_.intern(runtime::BankItem::Part, clip.skeleton), clip.bytes, tags);
  }

  BankWriter& writer_;
  runtime::BankForm form_;
  InternItem intern_ = [this](runtime::BankItem kind, std::span<const std::byte> bytes) {
    return writer_.intern(kind, bytes);
  };
  std::optional<BankFile> bank_;  // the last that was read from
  fs::path bank_path_;
};

void write_bank(const fs::path& path, const BankFile* old, std::vector<BankSource> sources,
                const BankOptions& options, const BankTexts& texts,
                const Observer<BankProgress>& observer) {
  std::ranges::stable_sort(sources, [](const BankSource& a, const BankSource& b) {
    return runtime::compare_names(a.name.data(), a.name.size(), b.name.data(), b.name.size()) < 0;
  });
  const auto twice = std::ranges::adjacent_find(sources, {}, &BankSource::name);
  if (twice != sources.end())
    throw InputError((twice + 1)->file.string(), 0, 0,
                     "would be the clip '" + twice->name + "', as " + twice->file.string());
  BankWriter writer(path, options.form);
  Filler filler(writer, options.form);
  const std::uint32_t kept = old != nullptr ? old->clips() : 0;
  BankProgress progress{0, sources.size() + kept};
  std::uint32_t next = 0;
  auto source = sources.begin();
  while (next < kept || source != sources.end()) {
    int order = next < kept ? -1 : 1;
    runtime::BankEntry entry;
    if (next < kept) {
      entry = old->entry(next);
      if (source != sources.end())
        order = runtime::compare_names(entry.name, entry.name_length, source->name.data(),
                                       source->name.size());
    }
    if (order < 0) filler.copy(*old, entry);
    if (order >= 0) filler.put(*source++, options.tags);
    if (order <= 0) ++next;
    if (order == 0) --progress.clips;
    ++progress.done;
    if (!should_continue(observer, progress)) return;
  }
  writer.finish(texts);
}

}  // namespace

std::string_view name(runtime::BankForm form) {
  return form == runtime::BankForm::Packed ? "packed" : "cooked";
}

std::optional<runtime::BankForm> bank_form(std::string_view name) {
  for (const runtime::BankForm form : {runtime::BankForm::Packed, runtime::BankForm::Cooked})
    if (mocapress::name(form) == name) return form;
  return std::nullopt;
}

std::vector<BankSource> find_bank_sources(const std::vector<fs::path>& inputs) {
  std::vector<BankSource> sources;
  for (const fs::path& input : inputs) {
    if (fs::is_directory(input))
      find_below(input, sources);
    else if (lower_extension(input) == ".mcpk")
      take_from(input, sources);
    else
      sources.push_back({input.stem().string(), input, {}});
  }
  return sources;
}

void make_bank(const fs::path& bank, std::vector<BankSource> sources, const BankOptions& options,
               const Observer<BankProgress>& observer) {
  write_bank(bank, nullptr, std::move(sources), options, options.texts, observer);
}

void add_to_bank(const fs::path& bank, std::vector<BankSource> sources, const BankOptions& options,
                 const Observer<BankProgress>& observer) {
  const BankFile old(bank);
  BankTexts texts = old.texts();
  for (const auto& [key, value] : options.texts) {
    const auto there = std::ranges::find(texts, key, &std::pair<std::string, std::string>::first);
    if (there != texts.end())
      there->second = value;
    else
      texts.emplace_back(key, value);
  }
  BankOptions of_old = options;
  of_old.form = old.bank().form;
  write_bank(bank, &old, std::move(sources), of_old, texts, observer);
}

}  // namespace mocapress
