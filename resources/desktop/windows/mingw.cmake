# SPDX-License-Identifier: MIT
# Toolchain: Windows on x86-64 by Debian's mingw-w64. Libraries are those that `libraries` beside this file has built.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)  # "posix": the variant that has std::thread
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
set(CMAKE_FIND_ROOT_PATH "${CMAKE_CURRENT_LIST_DIR}/../../../build/windows-libraries/installed" /usr/x86_64-w64-mingw32)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ZLIB_USE_STATIC_LIBS ON)  # else it would need zlib1.dll, which wine has and Windows has not
# No DLL of the compiler beside the program; the second option links what release builds check arrays with.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -fstack-protector-strong")
find_program(MOCAPRESS_WINE NAMES wine64 wine PATHS /usr/lib/wine)
set(CMAKE_CROSSCOMPILING_EMULATOR "${MOCAPRESS_WINE}")
