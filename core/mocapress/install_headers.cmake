# SPDX-License-Identifier: MIT
# Run by cmake --install: the public headers of the library, from ROOT to DESTINATION/mocapress, and below
# DESTINATION/mocapress/core those of core that they include, and so on. There all include one another as
# <mocapress/...>, so that one folder to search is enough.
cmake_minimum_required(VERSION 3.25)
set(headers core/mocapress/mocapress.h)
set(todo ${headers})
file(REMOVE_RECURSE "${FOLDER}")
while(todo)
  list(POP_FRONT todo header)
  # Lines without a bracket or a semicolon alone can be a list.
  file(STRINGS "${ROOT}/${header}" lines REGEX "^#include \"core/")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^#include \"(.*)\".*" "\\1" included "${line}")
    if(NOT included IN_LIST headers)
      list(APPEND headers ${included})
      list(APPEND todo ${included})
    endif()
  endforeach()
  file(READ "${ROOT}/${header}" text)
  string(REGEX REPLACE "#include \"core/mocapress/([^\"]*)\"" "#include <mocapress/\\1>" text "${text}")
  string(REGEX REPLACE "#include \"(core/[^\"]*)\"" "#include <mocapress/\\1>" text "${text}")
  string(REGEX REPLACE "^core/mocapress/" "" place "${header}")
  file(WRITE "${FOLDER}/mocapress/${place}" "${text}")
endwhile()
file(INSTALL "${FOLDER}/mocapress" DESTINATION "${DESTINATION}")
