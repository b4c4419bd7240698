# SPDX-License-Identifier: GPL-3.0-or-later
# `cpack -G DEB` in a release build. What the programs link is found by dpkg-shlibdeps; plugins, which
# they load by name, are not.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME mocapress)
set(CPACK_PACKAGE_CONTACT "The Mocapress developers <developers@mocapress.org>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};mocapress;Unspecified;/"
                                 "${PROJECT_BINARY_DIR};mocapress;library;/"
                                 "${PROJECT_BINARY_DIR};mocapress;runtime;/")
# The synopsis and what stands below it.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "studio and command line that compress motion capture clips")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
    "Mocapress keeps the wavelet coefficients of a motion that matter in the world
and shows the original and the compressed figure beside each other, with the
error in centimetres at every joint and frame. Clips come from BVH, Acclaim,
FBX and glTF files and become 40 to 150 times smaller at an error of a few
millimetres.

This package has the studio, the command line for many clips at a time, the
decoder that plays compressed clips in a game engine, and the C++ library.")
# Who compiles against the library needs these; who wants the studio does not.
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libeigen3-dev, libtbb-dev, zlib1g-dev, libmeshoptimizer-dev, libdraco-dev")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(MOCAPRESS_GUI)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "libqt6svg6, libgl1-mesa-dri, libegl1")
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "qt6-translations-l10n, fonts-dejavu-core, fonts-noto-cjk")
endif()
configure_file("${CMAKE_CURRENT_LIST_DIR}/debian/changelog.in" debian-changelog @ONLY)
set(CPACK_MOCAPRESS_CHANGELOG "${CMAKE_CURRENT_BINARY_DIR}/debian-changelog")
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/debian/finish.cmake")
include(CPack)
