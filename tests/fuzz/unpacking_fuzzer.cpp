// SPDX-License-Identifier: MIT
// Unpacks clips of any sound bank, with corrected checksums, as `bank extract` does, and copies
// them as `bank add` does.
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "core/bank/bank_writer.h"
#include "core/bank/cooked_tables.h"
#include "core/base/error.h"
#include "core/codec/format/packed_clip_writer.h"
#include "core/runtime/bank/bank_check.h"
#include "tests/fuzz/mended_bank.h"

namespace {

using namespace mocapress;

void unpack(const mcpk_bank& bank, const runtime::BankEntry& entry) {
  InternedBytes items[runtime::kBankItems];
  copy_outline(bank, entry.kind, [&](runtime::BankItem kind, std::span<const std::byte> bytes) {
    return items[static_cast<int>(kind)].intern(bytes);
  });
  try {
    // An unpacked clip can be packed again.
    pack_clip(unpack_clip(bank, entry));
  } catch (const FormatError&) {
  }
}

void copy(const mcpk_bank& bank, const runtime::BankEntry& entry) {
  const mcpr_cooked* clip = nullptr;
  if (runtime::cooked_clip_of(bank, entry, clip).status != MCPR_OK) std::abort();
  SharedTables tables;
  put_tables(*clip, tables);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const test::MendedBank mended(data, size);
  const mcpk_bank* bank = nullptr;
  if (mcpk_open(mended.data(), size, 1, &bank, nullptr) != MCPR_OK) return 0;
  for (std::uint32_t clip = 0; clip < std::min(bank->clips, 20U); ++clip) {
    runtime::BankEntry entry;
    if (!runtime::read_entry(*bank, clip, entry)) std::abort();
    bank->is_cooked() ? copy(*bank, entry) : unpack(*bank, entry);
  }
  return 0;
}
