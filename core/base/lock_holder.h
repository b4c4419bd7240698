// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/base/json_text.h"

namespace mocapress {

/// A run of a program that has locked a folder, as written in that folder for others to read.
struct LockHolder {
  std::string host;
  std::string user;
  long process = 0;
  std::string since;  // ISO 8601, UTC

  bool operator==(const LockHolder&) const = default;
};

/// Describes this process, since now.
LockHolder this_process();

/// "ana on render3, process 4711, since 2026-11-26T14:05:00Z"
std::string text(const LockHolder& holder);

Json to_json(const LockHolder& holder);

/// Reads what a holder wrote. Throws as the JSON library does.
LockHolder lock_holder_from(const Json& json);

}  // namespace mocapress
