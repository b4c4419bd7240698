# SPDX-License-Identifier: GPL-3.0-or-later
# CTest includes this, and asks a program for its suites: each is a process, for the start of a program with Qt takes longer
# than most of its tests. `program` is its path, `start` are words before it, `without` are tests that are added elsewhere.
execute_process(COMMAND "${program}" --gtest_list_tests OUTPUT_VARIABLE tests COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "\n" ";" lines "${tests}")
foreach(line IN LISTS lines)
  if(line MATCHES "^([^ ]+)\\.")  # tests are indented
    set(suite "${CMAKE_MATCH_1}")
    add_test("${suite}" ${start} "${program}" "--gtest_filter=${suite}.*-${without}")
    set_tests_properties("${suite}" PROPERTIES TIMEOUT 1800 ${properties})
  endif()
endforeach()
