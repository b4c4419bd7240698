// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace mocapress::cli {

/// The program's arguments in UTF-8. On Windows the arguments of main() are in a code page that
/// lacks most letters, so they are fetched anew. The constructor also sets the standard streams on
/// Windows: to pass bytes on unchanged, and to show UTF-8 on the console.
class Arguments {
 public:
  Arguments(int argc, char** argv);
  Arguments(const Arguments&) = delete;
  Arguments& operator=(const Arguments&) = delete;

  int count() const { return static_cast<int>(values_.size()) - 1; }
  char** values() const { return const_cast<char**>(values_.data()); }

 private:
  std::vector<std::string> texts_;
  std::vector<char*> values_;  // with a null at the end
};

}  // namespace mocapress::cli
