// SPDX-License-Identifier: MIT
#include <cstdio>
#include <exception>

#include "resources/samples/generator/samples.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: mocapress-make-samples OUT_DIR\n", stderr);
    return 2;
  }
  try {
    mocapress::samples::write_samples(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 5;
  }
  return 0;
}
