// SPDX-License-Identifier: MIT
#include "core/base/machine.h"

#include <filesystem>

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
  return is_found ? std::filesystem::path(name).string() : "";
}

std::string user_name() {
  wchar_t name[257];
  DWORD size = 257;
  return ::GetUserNameW(name, &size) ? std::filesystem::path(name).string() : "";
}

long process_number() {
  return static_cast<long>(::GetCurrentProcessId());
}

}  // namespace mocapress
