// SPDX-License-Identifier: MIT
#include "core/base/lock_holder.h"

#include <pwd.h>
#include <unistd.h>

#include <ctime>
#include <nlohmann/json.hpp>

#include "core/base/utc_time.h"

namespace mocapress {
namespace {

std::string host_name() {
  char name[256] = {};
  return ::gethostname(name, sizeof name - 1) == 0 ? name : "";
}

/// The user's name, or number if there is no name.
std::string user_name() {
  char buffer[4096];
  passwd entry{};
  passwd* found = nullptr;
  if (::getpwuid_r(::geteuid(), &entry, buffer, sizeof buffer, &found) == 0 && found)
    return found->pw_name;
  return std::to_string(::geteuid());
}

}  // namespace

LockHolder this_process() {
  return {host_name(), user_name(), ::getpid(), utc_text(std::time(nullptr))};
}

std::string text(const LockHolder& holder) {
  return holder.user + " on " + holder.host + ", process " + std::to_string(holder.process) +
         ", since " + holder.since;
}

Json to_json(const LockHolder& holder) {
  return {{"host", holder.host},
          {"user", holder.user},
          {"process", holder.process},
          {"since", holder.since}};
}

LockHolder lock_holder_from(const Json& json) {
  return {json.at("host").get<std::string>(), json.at("user").get<std::string>(),
          json.at("process").get<long>(), json.at("since").get<std::string>()};
}

}  // namespace mocapress
