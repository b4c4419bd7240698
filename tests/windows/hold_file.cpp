// SPDX-License-Identifier: MIT
// Holds a file as editors and players do, who let others read it but not write, rename or remove
// it, until standard input ends. Usage: hold_file FILE
#include <windows.h>

#include <iostream>

int main(int argc, char** argv) {
  const HANDLE file = argc == 2 ? CreateFileA(argv[1], GENERIC_READ, FILE_SHARE_READ, nullptr,
                                              OPEN_EXISTING, 0, nullptr)
                                : INVALID_HANDLE_VALUE;
  if (file == INVALID_HANDLE_VALUE) return 1;
  std::cout << "held" << std::endl;
  std::cin.ignore(1 << 20);
  CloseHandle(file);
  return 0;
}
