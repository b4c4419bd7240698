// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/base/json_text.h"

namespace mocapress {

/// A run of a program that has locked a folder. It is written into that folder, so that others can
/// tell who holds the lock.
struct LockHolder {
  std::string host;
  std::string user;
  long process = 0;
  std::string since;  // ISO 8601, UTC

  bool operator==(const LockHolder&) const = default;
};

/// Describes this process, with the current time as `since`.
LockHolder this_process();

/// Describes a holder: "ana on render3, process 4711, since 2026-11-26T14:05:00Z".
std::string text(const LockHolder& holder);

Json to_json(const LockHolder& holder);

/// Reads what to_json() wrote. Throws the JSON library's exceptions.
LockHolder lock_holder_from(const Json& json);

}  // namespace mocapress
