// SPDX-License-Identifier: MIT
#include "core/base/lock_holder.h"

#include <ctime>
#include <nlohmann/json.hpp>

#include "core/base/machine.h"
#include "core/base/utc_time.h"

namespace mocapress {

LockHolder this_process() {
  return {host_name(), user_name(), process_number(), utc_text(std::time(nullptr))};
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
