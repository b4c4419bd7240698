// SPDX-License-Identifier: MIT
#include "core/bank/bank.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "core/bank/bank_learning.h"
#include "core/bank/cooked_tables.h"
#include "core/base/error.h"
#include "core/codec/format/packed_clip_writer.h"
#include "core/runtime/bank_check.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

/// Puts clips into a new bank, wherever they come from.
class Filler {
 public:
  Filler(BankWriter& writer, runtime::BankForm form, std::vector<std::byte> learned)
      : writer_(writer), form_(form), learned_(std::move(learned)) {}

  void put(const BankSource& source, const std::vector<std::string>& tags) {
    BankSourceReader::File file = reader_.read(source);
    file.tags.insert(file.tags.end(), tags.begin(), tags.end());
    put_file(source.name, source.file.string(), file.bytes, file.tags);
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
  void put_file(const std::string& name, const std::string& file,
                const std::vector<std::byte>& bytes, const std::vector<std::string>& tags) try {
    if (form_ == runtime::BankForm::Cooked)
      return put_cooked(name, cook_for_bank(bytes, writer_.tables()), tags);
    const PackedClip packed = pack_clip(bytes, intern_, learned_);
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
  std::vector<std::byte> learned_;  // PRIO, which clips are coded by
  BankSourceReader reader_;
};

/// What clips of a bank are coded by; nothing where they are coded as all clips are.
std::vector<std::byte> learned_in(const mcpk_bank& bank) {
  for (std::uint32_t part = 0; part < bank.count(runtime::BankItem::Part); ++part) {
    const runtime::Bytes item = bank.item(runtime::BankItem::Part, part);
    const auto* const first = reinterpret_cast<const std::byte*>(item.data);
    if (item.size > 4 && std::memcmp(first, runtime::kLearned, 4) == 0)
      return {first + 4, first + item.size};
  }
  return {};
}

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
  const bool is_packed = options.form == runtime::BankForm::Packed;
  bool is_stopped = false;
  std::vector<std::byte> learned;
  if (is_packed && old != nullptr) learned = learned_in(old->bank());
  if (is_packed && old == nullptr && options.learn)
    learned = learn_from(sources, [&](const BankProgress& progress) {
      is_stopped = !should_continue(observer, progress);
      return !is_stopped;
    });
  if (is_stopped) return;
  Filler filler(writer, options.form, std::move(learned));
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
