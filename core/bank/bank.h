// SPDX-License-Identifier: MIT
// Banks on disk: made, added to, unpacked. The bytes are core/runtime/format/bank.h's.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/bank/bank_file.h"
#include "core/bank/bank_source.h"
#include "core/bank/bank_writer.h"
#include "core/bank/cooked_tables.h"
#include "core/base/error.h"
#include "core/base/progress.h"

namespace mocapress {

/// "packed", "cooked".
std::string_view name(runtime::BankForm form);

/// The form of this name; unset if there is none.
std::optional<runtime::BankForm> bank_form(std::string_view name);

struct BankOptions {
  runtime::BankForm form = runtime::BankForm::Packed;
  std::vector<std::string> tags;  // given to the clips that are put in
  BankTexts texts;                // the bank's own; an existing key gets the new value
  Cooking cooking;                // for the clips that are put into a cooked bank
  // For a packed bank: learns from its clips how to code their motions, which takes seconds and
  // pays from some hundred clips on.
  bool learn = false;
};

/// Progress in clips; 0 of 0 while another program changes the bank.
struct BankProgress {
  std::size_t done = 0;
  std::size_t clips = 0;
  std::optional<Warning> warning = {};  // given once, if the bank could not be locked
  std::uint64_t ik_bytes = 0;           // bytes of the IK corrections in the clips cooked so far
};

// One writer changes a bank at a time; others wait, in this program or another.

/// Makes a bank, which takes its place whole or not at all. False: the observer stopped it, and the
/// place is unchanged. Throws InputError, also if two clips have one name. Throws WriteError, also
/// if the place has a file that is no bank or a bank that a source belongs to.
bool make_bank(const std::filesystem::path& bank, std::vector<BankSource> sources,
               const BankOptions& options, const Observer<BankProgress>& observer = {});

/// Adds clips to a bank in its form. A clip replaces one of the same name, even if it came from
/// there.
bool add_to_bank(const std::filesystem::path& bank, std::vector<BankSource> sources,
                 const BankOptions& options, const Observer<BankProgress>& observer = {});

/// Removes clips from a bank, with the data that only they used. Throws InputError, also for a name
/// that is not in the bank.
bool remove_from_bank(const std::filesystem::path& bank, const std::vector<std::string>& names,
                      const Observer<BankProgress>& observer = {});

/// Writes a copy of a packed bank that has only the first tiers, 1 or more. Its bytes are those at
/// the beginning of the whole bank, but for the head. False: the observer stopped it, and the place
/// is unchanged. Throws InputError, also if the bank has fewer tiers, and WriteError as make_bank()
/// does.
bool strip_bank(const std::filesystem::path& bank, const std::filesystem::path& stripped, int tiers,
                const Observer<BankProgress>& observer = {});

}  // namespace mocapress
