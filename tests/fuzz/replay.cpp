// SPDX-License-Identifier: MIT
// Runs a fuzz target on every file of a folder once, which makes the corpus a plain test. All
// targets are one program: most of the time to compile them goes to headers that they share. Usage:
// mocapress-replay TARGET CORPUS
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <vector>

#include "fuzz_targets.inc"  // written by CMake: kTargets

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  int files = 0;
  for (const auto& [name, target] : kTargets) {
    if (name != std::string_view(argv[1])) continue;
    for (const auto& entry : std::filesystem::directory_iterator(argv[2])) {
      std::ifstream stream(entry.path(), std::ios::binary);
      const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
      target(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
      ++files;
    }
  }
  std::printf("%d files\n", files);
  return files > 0 ? 0 : 1;
}
