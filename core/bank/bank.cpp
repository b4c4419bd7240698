// SPDX-License-Identifier: MIT
#include "core/bank/bank.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <set>
#include <unordered_map>
#include <variant>

#include "core/bank/bank_learning.h"
#include "core/bank/cooked_tables.h"
#include "core/base/error.h"
#include "core/base/file_identity.h"
#include "core/base/file_lock.h"
#include "core/base/parallel_in_order.h"
#include "core/base/path_kind.h"
#include "core/base/utf8_path.h"
#include "core/codec/format/packed_clip_writer.h"
#include "core/runtime/bank/bank_check.h"
#include "core/runtime/format/bank_tiers.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

/// A clip ready to be put into a bank.
struct ReadyClip {
  std::vector<std::string> tags;
  std::variant<std::monostate, PackedClip, ClipForBank> clip;  // unset: copied from the old bank
};

/// The pieces that finer tiers add to a clip of a packed bank.
ClipPieces pieces_of(const mcpk_bank& bank, std::uint32_t clip) {
  ClipPieces pieces;
  const runtime::BankTiers tiers(bank);
  for (int t = 1; t < tiers.count(); ++t) {
    const runtime::Bytes piece = bank.bytes_of(tiers.piece(t, clip));
    const auto* const first = reinterpret_cast<const std::byte*>(piece.data);
    pieces.emplace_back(first, first + piece.size);
  }
  while (!pieces.empty() && pieces.back().empty()) pieces.pop_back();
  return pieces;
}

/// Puts clips from any source into a new bank.
class Filler {
 public:
  Filler(BankWriter& writer, const BankOptions& options, const BankSourceReader& files,
         std::vector<std::byte> learned)
      : writer_(writer), options_(options), files_(files), learned_(std::move(learned)) {}

  /// Does the part of a clip's work that needs no other clip in the bank. Many threads may call it.
  ReadyClip prepare(const BankSource& source) const try {
    BankSourceReader::File file = files_.read(source);
    ReadyClip ready{std::move(file.tags), {}};
    if (options_.form == runtime::BankForm::Cooked)
      ready.clip = cook_for_bank(file.bytes, options_.cooking);
    else
      ready.clip = pack_clip(file.bytes, learned_);
    return ready;
  } catch (const FormatError& error) {
    throw InputError(utf8(source.file), 0, 0, error.what());
  }

  /// Returns how many bytes the IK corrections take in the clips put so far.
  std::uint64_t ik_bytes() const { return ik_bytes_; }

  void put(const std::string& name, ReadyClip ready) {
    ready.tags.insert(ready.tags.end(), options_.tags.begin(), options_.tags.end());
    if (const auto* const packed = std::get_if<PackedClip>(&ready.clip)) {
      writer_.add(name, intern_outline(*packed, intern_), packed->bytes, std::move(ready.tags),
                  packed->pieces);
    } else if (const auto* const cooked = std::get_if<ClipForBank>(&ready.clip)) {
      put_cooked(name, cooked->cooked(), cooked->skeleton, std::move(ready.tags));
      ik_bytes_ += cooked->ik_bytes;
    }
  }

  /// Copies a clip from a bank of the same form, packed or cooked.
  void copy(const BankFile& bank, const runtime::BankEntry& entry) {
    std::vector<std::string> tags = bank.tags(entry);
    if (!bank.is_cooked()) {
      const auto* const first =
          reinterpret_cast<const std::byte*>(bank.bank().at(entry.place.offset));
      writer_.add(entry.name, copied_outline(bank.bank(), entry.kind),
                  {first, static_cast<std::size_t>(entry.place.bytes)}, std::move(tags),
                  pieces_of(bank.bank(), entry.number));
      return;
    }
    const mcpr_cooked* const cooked = bank.cooked(entry);
    const runtime::Bytes skeleton = bank.bank().item(runtime::BankItem::Part, entry.kind);
    put_cooked(entry.name, *cooked,
               {reinterpret_cast<const std::byte*>(skeleton.data), skeleton.size}, std::move(tags));
  }

 private:
  /// Returns the outline's number in the new bank. Copies the outline there on first use.
  std::uint32_t copied_outline(const mcpk_bank& bank, std::uint32_t outline) {
    const auto there = copied_outlines_.find(outline);
    if (there != copied_outlines_.end()) return there->second;
    return copied_outlines_[outline] = copy_outline(bank, outline, intern_);
  }

  void put_cooked(const std::string& name, const mcpr_cooked& clip,
                  std::span<const std::byte> skeleton, std::vector<std::string> tags) {
    const std::vector<std::byte> bytes = put_tables(clip, writer_.tables());
    writer_.add(name, writer_.intern(runtime::BankItem::Part, skeleton), bytes, std::move(tags));
  }

  BankWriter& writer_;
  const BankOptions& options_;
  std::uint64_t ik_bytes_ = 0;
  const BankSourceReader& files_;
  InternItem intern_ = [this](runtime::BankItem kind, std::span<const std::byte> bytes) {
    return writer_.intern(kind, bytes);
  };
  std::vector<std::byte> learned_;  // payload of PRIO, the priors that clips are coded with
  // Numbers in the new bank, by numbers in the old one.
  std::unordered_map<std::uint32_t, std::uint32_t> copied_outlines_;
};

/// A clip to put next: from the old bank if is_copy, else from a source.
struct Step {
  std::uint32_t number;
  bool is_copy;
};

/// Returns all clips in the order of their names. Clips of the old bank that are removed, or share
/// a name with a source, are left out.
std::vector<Step> merged(const BankFile* old, const std::set<std::uint32_t>& removed,
                         const std::vector<BankSource>& sources) {
  std::vector<Step> steps;
  const auto end = static_cast<std::uint32_t>(sources.size());
  std::uint32_t source = 0;
  const std::uint32_t kept = old != nullptr ? old->clips() : 0;
  for (std::uint32_t clip = 0; clip < kept; ++clip) {
    const runtime::BankEntry entry = old->entry(clip);
    const auto order = [&] {
      const std::string& name = sources[source].name;
      return runtime::compare_names(entry.name, entry.name_length, name.data(), name.size());
    };
    while (source < end && order() > 0) steps.push_back({source++, false});
    const bool is_replaced = source < end && order() == 0;
    if (!is_replaced && !removed.contains(clip)) steps.push_back({clip, true});
  }
  while (source < end) steps.push_back({source++, false});
  return steps;
}

/// Returns the learned priors (payload of PRIO) that a bank's clips are coded with. Empty: the bank
/// has none, so its clips are coded like clips outside a bank.
std::vector<std::byte> learned_in(const mcpk_bank& bank) {
  for (std::uint32_t part = 0; part < bank.count(runtime::BankItem::Part); ++part) {
    const runtime::Bytes item = bank.item(runtime::BankItem::Part, part);
    const auto* const first = reinterpret_cast<const std::byte*>(item.data);
    if (item.size > 4 && std::memcmp(first, runtime::kLearned, 4) == 0)
      return {first + 4, first + item.size};
  }
  return {};
}

/// Throws if `path` holds a file that is not a bank, or one of the sources, so that a slip in the
/// command line destroys nothing.
void require_place_for_bank(const fs::path& path, const std::vector<BankSource>& sources) {
  if (path_kind(path) != PathKind::File) return;
  for (const BankSource& source : sources) refuse_source(path, {source.file});
  const std::optional<mcpk_bank> there = read_bank_head(path);
  if (there && std::memcmp(there->magic, mcpk_bank::kMagic, sizeof there->magic) != 0)
    throw WriteError(utf8(path) + ": is there and is no bank: not overwritten");
}

/// Locks the bank. Returns nothing if the observer stopped it.
std::optional<FileLock> lock_bank(const fs::path& path, const Observer<BankProgress>& observer) {
  std::optional<FileLock> lock =
      FileLock::wait_for(path, [&] { return should_continue(observer, BankProgress{}); });
  if (lock && lock->warning() && !should_continue(observer, BankProgress{0, 0, lock->warning()}))
    return std::nullopt;
  return lock;
}

/// Writes the bank. Returns false if the observer stopped it.
bool write_bank(const fs::path& path, const BankFile* old, const std::set<std::uint32_t>& removed,
                std::vector<BankSource> sources, const BankOptions& options, const BankTexts& texts,
                const Observer<BankProgress>& observer) {
  std::ranges::stable_sort(sources, [](const BankSource& a, const BankSource& b) {
    return runtime::compare_names(a.name.data(), a.name.size(), b.name.data(), b.name.size()) < 0;
  });
  const auto twice = std::ranges::adjacent_find(sources, {}, &BankSource::name);
  if (twice != sources.end())
    throw InputError(utf8((twice + 1)->file), 0, 0,
                     "would be the clip '" + twice->name + "', as " + utf8(twice->file));
  if (old != nullptr &&
      runtime::BankTiers(old->bank()).present() < runtime::BankTiers(old->bank()).count())
    throw InputError(utf8(path), 0, 0,
                     "lacks its finer tiers: clips are added to and removed from the whole bank");
  BankWriter writer(path, options.form);
  const BankSourceReader files(sources);
  const bool is_packed = options.form == runtime::BankForm::Packed;
  bool is_stopped = false;
  std::vector<std::byte> learned;
  if (is_packed && old != nullptr) learned = learned_in(old->bank());
  if (is_packed && old == nullptr && options.learn)
    learned = learn_from(sources, files, [&](const BankProgress& progress) {
      is_stopped = !should_continue(observer, progress);
      return !is_stopped;
    });
  if (is_stopped) return false;
  Filler filler(writer, options, files, std::move(learned));
  const std::vector<Step> steps = merged(old, removed, sources);
  parallel_in_order(
      steps.size(),
      [&](std::size_t step) {
        return steps[step].is_copy ? ReadyClip() : filler.prepare(sources[steps[step].number]);
      },
      [&](std::size_t step, ReadyClip ready) {
        const std::uint32_t number = steps[step].number;
        if (steps[step].is_copy)
          filler.copy(*old, old->entry(number));
        else
          filler.put(sources[number].name, std::move(ready));
        is_stopped =
            !should_continue(observer, BankProgress{step + 1, steps.size(), {}, filler.ik_bytes()});
        return !is_stopped;
      });
  if (!is_stopped) writer.finish(texts);
  return !is_stopped;
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

bool make_bank(const fs::path& bank, std::vector<BankSource> sources, const BankOptions& options,
               const Observer<BankProgress>& observer) {
  const std::optional<FileLock> lock = lock_bank(bank, observer);
  if (!lock) return false;
  require_place_for_bank(bank, sources);
  return write_bank(bank, nullptr, {}, std::move(sources), options, options.texts, observer);
}

bool add_to_bank(const fs::path& bank, std::vector<BankSource> sources, const BankOptions& options,
                 const Observer<BankProgress>& observer) {
  const std::optional<FileLock> lock = lock_bank(bank, observer);
  if (!lock) return false;
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
  return write_bank(bank, &old, {}, std::move(sources), of_old, texts, observer);
}

bool strip_bank(const fs::path& bank, const fs::path& stripped, int tiers,
                const Observer<BankProgress>& observer) {
  const std::optional<FileLock> lock = lock_bank(stripped, observer);
  if (!lock) return false;
  const BankFile whole(bank);
  if (whole.is_cooked()) throw InputError(utf8(bank), 0, 0, "is cooked, and has no tiers");
  require_place_for_bank(stripped, {BankSource{.file = bank}});
  const runtime::BankTiers there(whole.bank());
  if (tiers < 1 || tiers > there.present())
    throw InputError(
        utf8(bank), 0, 0,
        "has " + std::to_string(there.present()) + " tiers, not " + std::to_string(tiers));
  mcpk_bank head = whole.bank();
  const runtime::BankRegion last = tiers == 1 ? head.tables : there.region(tiers - 1);
  head.bytes = last.offset + last.bytes;
  head.checksum = runtime::bank_checksum(&head, offsetof(mcpk_bank, checksum));
  const auto head_bytes = std::as_bytes(std::span(&head, 1));
  const auto* const first = reinterpret_cast<const std::byte*>(whole.bank().at(0));
  StagedFile file(stripped);
  file.write(head_bytes);
  file.write({first + head_bytes.size(), first + head.bytes});
  file.commit();
  return true;
}

bool remove_from_bank(const fs::path& bank, const std::vector<std::string>& names,
                      const Observer<BankProgress>& observer) {
  const std::optional<FileLock> lock = lock_bank(bank, observer);
  if (!lock) return false;
  const BankFile old(bank);
  std::set<std::uint32_t> removed;
  for (const std::string& name : names) removed.insert(old.find(name));
  return write_bank(bank, &old, removed, {}, {.form = old.bank().form}, old.texts(), observer);
}

}  // namespace mocapress
