# SPDX-License-Identifier: GPL-3.0-or-later
# Run by cpack on what was staged: what Debian's policy wants of a package, and other systems do not.
set(staged "${CPACK_TEMPORARY_DIRECTORY}/usr")
set(documents "${staged}/share/doc/mocapress")

file(MAKE_DIRECTORY "${documents}")
configure_file("${CMAKE_CURRENT_LIST_DIR}/copyright" "${documents}/copyright" COPYONLY
               FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
configure_file("${CPACK_MOCAPRESS_CHANGELOG}" "${documents}/changelog.Debian" COPYONLY
               FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)

# -n: no name and no time, so that the same tree gives the same package.
file(GLOB pages "${staged}/share/man/man*/*.[1-9]")
execute_process(COMMAND gzip -9 -n ${pages} "${documents}/changelog.Debian"
                COMMAND_ERROR_IS_FATAL ANY)
