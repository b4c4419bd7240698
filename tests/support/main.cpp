// SPDX-License-Identifier: MIT
// Runs the tests of a program, in the locale that MOCAPRESS_TEST_LOCALE names where it is set: see
// decimal_commas.
#include <gtest/gtest.h>

#include <cstdlib>
#include <locale>

#include "core/baselines/rivals.h"

int main(int argc, char** argv) {
  mocapress::add_rivals();  // tests ask for them while they are listed
  testing::InitGoogleTest(&argc, argv);
  // Reports of programs that tests run carry one date, so that their bytes can be compared.
  ::setenv("SOURCE_DATE_EPOCH", "1700000000", 0);
  if (const char* wanted = std::getenv("MOCAPRESS_TEST_LOCALE"))
    std::locale::global(std::locale(wanted));  // C's too
  return RUN_ALL_TESTS();
}
