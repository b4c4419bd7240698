// SPDX-License-Identifier: MIT
// Runs a program's tests in the locale named by MOCAPRESS_TEST_LOCALE, if set: see decimal_commas.
#include <gtest/gtest.h>

#include <cstdlib>
#include <locale>

#include "core/baselines/rivals.h"

int main(int argc, char** argv) {
  mocapress::add_rivals();  // tests use them while they are listed
  testing::InitGoogleTest(&argc, argv);
  // A fixed date makes the bytes of reports comparable.
#ifdef _WIN32
  ::_putenv_s("SOURCE_DATE_EPOCH", "1700000000");
#else
  ::setenv("SOURCE_DATE_EPOCH", "1700000000", 0);
#endif
  if (const char* wanted = std::getenv("MOCAPRESS_TEST_LOCALE"))
    std::locale::global(std::locale(wanted));  // sets C's locale too
  return RUN_ALL_TESTS();
}
