// SPDX-License-Identifier: MIT
// Banks on disk: made, added to, unpacked. The bytes are core/runtime/format/bank.h's.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/bank/bank_file.h"
#include "core/bank/bank_source.h"
#include "core/bank/bank_writer.h"
#include "core/base/error.h"
#include "core/base/progress.h"

namespace mocapress {

/// "packed", "cooked".
std::string_view name(runtime::BankForm form);

/// Unset when it is neither.
std::optional<runtime::BankForm> bank_form(std::string_view name);

struct BankOptions {
  runtime::BankForm form = runtime::BankForm::Packed;
  std::vector<std::string> tags;  // of the clips that are put in
  BankTexts texts;                // of the bank; a key that is there gets the new value
  bool learn = false;  // packed, when it is made: code motions by what the clips teach, which takes
                       // seconds and pays from some hundred clips on
};

/// Clips done, of so many; of none while another program changes the bank.
struct BankProgress {
  std::size_t done = 0;
  std::size_t clips = 0;
  std::optional<Warning> warning = {};  // told once: that the bank could not be locked
};

// One at a time changes a bank: another waits for it, in this program or any other.

/// Makes a bank, which takes its place whole or not at all. False: the observer said no, and the
/// place is as it was. Throws InputError, also where two clips have one name, and WriteError, also
/// where the place has a file that is no bank or a bank of which a source is.
bool make_bank(const std::filesystem::path& bank, std::vector<BankSource> sources,
               const BankOptions& options, const Observer<BankProgress>& observer = {});

/// The same with what the bank holds already, in its form: a clip of a name that is there takes its
/// place, also if it came from there.
bool add_to_bank(const std::filesystem::path& bank, std::vector<BankSource> sources,
                 const BankOptions& options, const Observer<BankProgress>& observer = {});

/// The same without some clips, and what only they had. Throws InputError, also for a name that
/// it does not hold.
bool remove_from_bank(const std::filesystem::path& bank, const std::vector<std::string>& names,
                      const Observer<BankProgress>& observer = {});

}  // namespace mocapress
