// SPDX-License-Identifier: MIT
#include "core/base/machine.h"

#include <filesystem>

#include "core/base/utf8_path.h"
#include "core/base/windows/system.h"

namespace mocapress {

std::uint64_t physical_memory() {
  MEMORYSTATUSEX status{};
  status.dwLength = sizeof status;
  return ::GlobalMemoryStatusEx(&status) ? status.ullTotalPhys : 0;
}

std::string host_name() {
  wchar_t name[256];
  DWORD size = 256;
  const bool is_found = ::GetComputerNameExW(ComputerNameDnsHostname, name, &size);
  return is_found ? utf8(name) : "";
}

std::string user_name() {
  wchar_t name[257];
  DWORD size = 257;
  return ::GetUserNameW(name, &size) ? utf8(name) : "";
}

long process_number() {
  return static_cast<long>(::GetCurrentProcessId());
}

}  // namespace mocapress
