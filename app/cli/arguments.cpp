// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/arguments.h"

#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#include <fcntl.h>
#include <io.h>
#include <windows.h>
// shellapi.h needs windows.h before it.
#include <shellapi.h>

#include <cstdio>
#include <filesystem>
#endif

namespace mocapress::cli {

#ifdef _WIN32
Arguments::Arguments(int argc, char** argv) : texts_(argv, argv + argc) {
  for (std::FILE* const stream : {stdin, stdout, stderr}) _setmode(_fileno(stream), _O_BINARY);
  SetConsoleOutputCP(CP_UTF8);
  int count = 0;
  wchar_t** const wide = CommandLineToArgvW(GetCommandLineW(), &count);
  if (wide) texts_.clear();
  for (int i = 0; wide && i < count; ++i) {
    // A name that is not valid UTF-16 loses only its invalid letters.
    std::string text(static_cast<std::size_t>(WideCharToMultiByte(CP_UTF8, 0, wide[i], -1, nullptr,
                                                                  0, nullptr, nullptr)),
                     '\0');
    WideCharToMultiByte(CP_UTF8, 0, wide[i], -1, text.data(), static_cast<int>(text.size()),
                        nullptr, nullptr);
    text.pop_back();  // the terminating zero
    texts_.push_back(text);
  }
  if (wide) LocalFree(wide);
  for (std::string& text : texts_) values_.push_back(text.data());
  values_.push_back(nullptr);
}
#else
Arguments::Arguments(int argc, char** argv) : values_(argv, argv + argc + 1) {}
#endif

}  // namespace mocapress::cli
