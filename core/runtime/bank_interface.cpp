// SPDX-License-Identifier: MIT
// The part of the C interface that reads banks: checks the arguments, then calls the
// implementation.
#include <cstring>
#include <limits>

#include "core/runtime/bank/bank_check.h"
#include "core/runtime/decode/file_loader.h"
#include "core/runtime/format/bank_skeleton.h"
#include "core/runtime/format/bank_tiers.h"
#include "core/runtime/format/file_sections.h"
#include "core/runtime/mocapress_runtime.h"

static_assert(MCPK_HEAD_BYTES == sizeof(mcpk_bank));
static_assert(MCPK_NAME_BYTES == mocapress::runtime::kMostNameOfClip + 1);

namespace mocapress::runtime {
namespace {

constexpr mcpr_result no_such(const char* message) {
  return failure(MCPR_ARGUMENT, 0, message);
}

mcpr_result find_entry(const mcpk_bank* bank, std::uint32_t clip, bool is_cooked,
                       BankEntry& entry) {
  if (bank == nullptr) return no_such("no bank");
  if (bank->is_cooked() != is_cooked)
    return no_such(is_cooked ? "the bank is packed: its clips are read, not used as they lie"
                             : "the bank is cooked: its clips are used as they lie, not read");
  if (clip >= bank->clips) return no_such("no such clip");
  return read_entry(*bank, clip, entry)
             ? kOk
             : failure(MCPR_DAMAGED, static_cast<std::size_t>(bank->index.offset),
                       "the index of the bank is damaged");
}

mcpr_result inspect(const mcpk_bank* bank, std::uint32_t clip, const mcpr_limits& limits,
                    FileSections& sections, std::uint64_t& read_bytes) {
  BankEntry entry;
  mcpr_result result = find_entry(bank, clip, false, entry);
  if (!failed(result)) result = read_sections(*bank, entry, limits, sections);
  return failed(result) ? result : find_read_bytes(sections, limits, read_bytes);
}

}  // namespace
}  // namespace mocapress::runtime

namespace runtime = mocapress::runtime;

mcpr_status mcpk_open(const void* memory, size_t size, int check, const mcpk_bank** bank,
                      mcpr_result* report) {
  if (bank == nullptr)
    return runtime::tell(report, runtime::no_such("no place was given for the bank"));
  mcpr_result result = runtime::check_memory(memory, size, 0, "");
  if (runtime::failed(result)) return runtime::tell(report, result);
  const auto* const head = static_cast<const mcpk_bank*>(memory);
  result = runtime::check_bank_head(*head, size);
  if (!runtime::failed(result) && check != 0) result = runtime::check_bank(*head, check != 2);
  if (!runtime::failed(result)) *bank = head;
  return runtime::tell(report, result);
}

void mcpk_describe(const mcpk_bank* bank, mcpk_info* out) {
  if (out == nullptr) return;
  *out = {};
  if (bank == nullptr) return;
  *out = {.bytes = bank->bytes,
          .clips = bank->clips,
          .tags = bank->count(runtime::BankItem::Tag),
          .texts = bank->count(runtime::BankItem::Text) / 2,
          .is_cooked = bank->is_cooked() ? 1 : 0,
          .table_bytes = bank->is_cooked() ? static_cast<std::size_t>(bank->tables.bytes) : 0,
          .skeletons = bank->count(runtime::BankItem::Part)};
}

int32_t mcpk_find(const mcpk_bank* bank, const char* name) {
  if (bank == nullptr || name == nullptr) return -1;
  return static_cast<std::int32_t>(runtime::find_clip(*bank, name, std::strlen(name)));
}

size_t mcpk_name(const mcpk_bank* bank, uint32_t clip, char* name) {
  runtime::BankEntry entry;
  if (bank == nullptr || name == nullptr || !runtime::read_entry(*bank, clip, entry)) return 0;
  std::memcpy(name, entry.name, std::size_t{entry.name_length} + 1);
  return entry.name_length;
}

const char* mcpk_tag(const mcpk_bank* bank, uint32_t clip, uint32_t number) {
  runtime::BankEntry entry;
  if (bank == nullptr || !runtime::read_entry(*bank, clip, entry)) return nullptr;
  const runtime::Bytes set = bank->item(runtime::BankItem::TagSet, entry.tag_set);
  if (number >= set.size / sizeof(std::uint32_t)) return nullptr;
  std::uint32_t tag = 0;
  std::memcpy(&tag, set.data + sizeof tag * number, sizeof tag);
  return bank->text(runtime::BankItem::Tag, tag);
}

const char* mcpk_key(const mcpk_bank* bank, uint32_t number) {
  if (bank == nullptr || number >= bank->count(runtime::BankItem::Text) / 2) return nullptr;
  return bank->text(runtime::BankItem::Text, 2 * number);
}

const char* mcpk_value(const mcpk_bank* bank, uint32_t number) {
  if (bank == nullptr || number >= bank->count(runtime::BankItem::Text) / 2) return nullptr;
  return bank->text(runtime::BankItem::Text, 2 * number + 1);
}

mcpr_status mcpk_place(const mcpk_bank* bank, uint32_t clip, uint64_t* offset, uint64_t* bytes,
                       mcpr_result* report) {
  if (bank == nullptr || offset == nullptr || bytes == nullptr)
    return runtime::tell(report, runtime::no_such("no bank, or no place was given for the answer"));
  runtime::BankRegion place{bank->items.offset,
                            bank->tables.offset + bank->tables.bytes - bank->items.offset};
  if (clip != bank->clips) {
    runtime::BankEntry entry;
    const mcpr_result result = runtime::find_entry(bank, clip, bank->is_cooked(), entry);
    if (runtime::failed(result)) return runtime::tell(report, result);
    place = entry.place;
  }
  *offset = place.offset;
  *bytes = place.bytes;
  return runtime::tell(report, runtime::kOk);
}

uint32_t mcpk_tiers(const mcpk_bank* bank, uint32_t* present) {
  if (present != nullptr) *present = 0;
  if (bank == nullptr) return 0;
  const runtime::BankTiers tiers(*bank);
  if (present != nullptr) *present = static_cast<std::uint32_t>(tiers.present());
  return static_cast<std::uint32_t>(tiers.count());
}

mcpr_status mcpk_tier_place(const mcpk_bank* bank, uint32_t clip, uint32_t tier, uint64_t* offset,
                            uint64_t* bytes, mcpr_result* report) {
  if (tier == 0) return mcpk_place(bank, clip, offset, bytes, report);
  if (bank == nullptr || offset == nullptr || bytes == nullptr)
    return runtime::tell(report, runtime::no_such("no bank, or no place was given for the answer"));
  const runtime::BankTiers tiers(*bank);
  if (tier >= static_cast<std::uint32_t>(tiers.count()) || clip > bank->clips)
    return runtime::tell(report, runtime::no_such("no such tier or clip"));
  const auto number = static_cast<int>(tier);
  const runtime::BankRegion place =
      clip == bank->clips ? tiers.region(number) : tiers.piece(number, clip);
  *offset = place.offset;
  *bytes = place.bytes;
  return runtime::tell(report, runtime::kOk);
}

mcpr_status mcpk_check(const mcpk_bank* bank, uint32_t clip, mcpr_result* report) {
  if (bank == nullptr) return runtime::tell(report, runtime::no_such("no bank"));
  runtime::BankEntry entry;
  const mcpr_result result = runtime::find_entry(bank, clip, bank->is_cooked(), entry);
  return runtime::tell(report,
                       runtime::failed(result) ? result : runtime::check_clip(*bank, entry));
}

mcpr_status mcpk_inspect(const mcpk_bank* bank, uint32_t clip, const mcpr_limits* limits,
                         mcpr_info* info, mcpr_result* report) {
  if (info == nullptr)
    return runtime::tell(report, runtime::no_such("no place was given for what the clip holds"));
  runtime::FileSections sections;
  std::uint64_t bytes = 0;
  const mcpr_result result =
      runtime::inspect(bank, clip, runtime::or_default(limits), sections, bytes);
  if (!runtime::failed(result)) *info = runtime::info_of(sections, bytes);
  return runtime::tell(report, result);
}

mcpr_status mcpk_read(const mcpk_bank* bank, uint32_t clip, const mcpr_limits* limits,
                      void* scratch, size_t scratch_size, size_t* resident_bytes,
                      mcpr_result* report) {
  if (resident_bytes == nullptr)
    return runtime::tell(report, runtime::no_such("no place was given for the size of the clip"));
  const mcpr_limits applied = runtime::or_default(limits);
  runtime::FileSections sections;
  std::uint64_t bytes = 0;
  const mcpr_result result = runtime::inspect(bank, clip, applied, sections, bytes);
  if (runtime::failed(result)) return runtime::tell(report, result);
  return runtime::tell(
      report, runtime::read_into(sections, bytes, applied, scratch, scratch_size, *resident_bytes));
}

mcpr_status mcpk_cooked(const mcpk_bank* bank, uint32_t clip, const mcpr_cooked** cooked,
                        mcpr_result* report) {
  if (cooked == nullptr)
    return runtime::tell(report, runtime::no_such("no place was given for the clip"));
  runtime::BankEntry entry;
  const mcpr_result result = runtime::find_entry(bank, clip, true, entry);
  return runtime::tell(
      report, runtime::failed(result) ? result : runtime::cooked_clip_of(*bank, entry, *cooked));
}

mcpr_status mcpk_joint(const mcpk_bank* bank, uint32_t clip, uint32_t joint, mcpr_joint* out,
                       mcpr_result* report) {
  runtime::BankEntry entry;
  const mcpr_result result = runtime::find_entry(bank, clip, true, entry);
  if (runtime::failed(result)) return runtime::tell(report, result);
  const runtime::BankSkeleton skeleton(bank->item(runtime::BankItem::Part, entry.kind));
  if (joint >= skeleton.joints() || out == nullptr)
    return runtime::tell(report, runtime::no_such("no such joint, or no place was given for it"));
  *out = skeleton.described(joint);
  if (out->name == nullptr) out->name = "";  // in a bank that was not checked
  return runtime::tell(report, runtime::kOk);
}

int32_t mcpk_find_joint(const mcpk_bank* bank, uint32_t clip, const char* name) {
  runtime::BankEntry entry;
  if (name == nullptr || runtime::failed(runtime::find_entry(bank, clip, true, entry))) return -1;
  const runtime::BankSkeleton skeleton(bank->item(runtime::BankItem::Part, entry.kind));
  for (std::uint32_t j = 0; j < skeleton.joints(); ++j) {
    const char* const own = skeleton.name(skeleton.joint(j));
    if (own != nullptr && std::strcmp(own, name) == 0) return static_cast<std::int32_t>(j);
  }
  return -1;
}
