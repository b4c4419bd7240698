# SPDX-License-Identifier: GPL-3.0-or-later
# `cpack -G DEB` in a release build. What the programs link is found by dpkg-shlibdeps; plugins, which
# they load by name, are not.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME mocapress)
set(CPACK_PACKAGE_CONTACT "The Mocapress developers <mocapress@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
if(MOCAPRESS_GUI)
  set(CPACK_DEBIAN_PACKAGE_DEPENDS "libqt6svg6, libgl1-mesa-dri, libegl1")
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "qt6-translations-l10n, fonts-dejavu-core, fonts-noto-cjk")
endif()
include(CPack)
