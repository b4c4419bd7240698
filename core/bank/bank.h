// SPDX-License-Identifier: MIT
// Makes banks on disk, adds clips to them and removes clips. core/runtime/format/bank.h defines
// their bytes.
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

/// The name of a form: "packed" or "cooked".
std::string_view name(runtime::BankForm form);

/// Returns the form with this name, if there is one.
std::optional<runtime::BankForm> bank_form(std::string_view name);

struct BankOptions {
  runtime::BankForm form = runtime::BankForm::Packed;
  std::vector<std::string> tags;  // added to the tags of every clip that is put in
  BankTexts texts;                // describe the bank; an existing key gets the new value
  Cooking cooking;                // used for clips that are put into a cooked bank
  // Packed banks only: learn from the clips how to code their motions. This takes seconds and pays
  // off from some hundred clips on.
  bool learn = false;
};

/// Progress in clips; both counts are 0 while waiting for another program that changes the bank.
struct BankProgress {
  std::size_t done = 0;
  std::size_t clips = 0;
  std::optional<Warning> warning = {};  // given once, if the bank could not be locked
  std::uint64_t ik_bytes = 0;           // bytes of the IK corrections in the clips cooked so far
};

// Only one writer changes a bank at a time; others wait, whether in this program or another.

/// Makes a bank, which appears at its path whole or not at all. Returns false, and leaves the path
/// unchanged, if the observer stopped it. Throws InputError, also if two clips have the same name.
/// Throws WriteError, also if the path holds a file that is not a bank, or one of the sources.
bool make_bank(const std::filesystem::path& bank, std::vector<BankSource> sources,
               const BankOptions& options, const Observer<BankProgress>& observer = {});

/// Adds clips to a bank, in the bank's form. A clip replaces the bank's clip of the same name, even
/// if it was read from there.
bool add_to_bank(const std::filesystem::path& bank, std::vector<BankSource> sources,
                 const BankOptions& options, const Observer<BankProgress>& observer = {});

/// Removes clips from a bank, and shared data that no other clip uses. Throws InputError, also for
/// a name that is not in the bank.
bool remove_from_bank(const std::filesystem::path& bank, const std::vector<std::string>& names,
                      const Observer<BankProgress>& observer = {});

/// Writes a copy of a packed bank that has only the first `tiers` tiers, 1 or more. Apart from the
/// head, its bytes are the beginning of the whole bank. Returns false, and leaves the path
/// unchanged, if the observer stopped it. Throws InputError, also if the bank has fewer tiers, and
/// WriteError as make_bank() does.
bool strip_bank(const std::filesystem::path& bank, const std::filesystem::path& stripped, int tiers,
                const Observer<BankProgress>& observer = {});

}  // namespace mocapress
