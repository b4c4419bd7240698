// SPDX-License-Identifier: MIT
#include "core/base/end_without_memory.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

namespace mocapress {

void end_without_memory_by(int exit_code) {
  static int code;
  static std::terminate_handler usual;
  code = exit_code;
  usual = std::set_terminate([] {
    try {
      if (std::current_exception()) throw;
    } catch (const std::bad_alloc&) {
      std::fputs("mocapress: takes more memory than this machine has to give\n", stderr);
      std::_Exit(code);
    } catch (...) {
    }
    usual();
  });
}

}  // namespace mocapress
