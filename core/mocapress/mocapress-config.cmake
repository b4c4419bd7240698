# SPDX-License-Identifier: MIT
# find_package(mocapress): mocapress::mocapress, a static library, and with it mocapress::runtime.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4 NO_MODULE)
find_dependency(TBB)
find_dependency(ZLIB)
find_dependency(mocapress-runtime)
include("${CMAKE_CURRENT_LIST_DIR}/mocapress-targets.cmake")
