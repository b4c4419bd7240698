# SPDX-License-Identifier: GPL-3.0-or-later
# The libraries that the programs are made of, as CycloneDX 1.5 has it: whoever hears of a flaw in one of
# them can ask whether it is in here.
set(components "")
foreach(library core:Eigen3:MPL-2.0 core:ZLIB:Zlib core:TBB:Apache-2.0 core:nlohmann_json:MIT app/cli:CLI11:BSD-3-Clause
                core/formats:meshoptimizer:MIT core/formats:draco:Apache-2.0 .:Qt6:LGPL-3.0-only
                .:QCustomPlotQt6:GPL-3.0-or-later)
  string(REPLACE ":" ";" library "${library}")
  list(GET library 0 folder)
  list(GET library 1 name)
  list(GET library 2 licence)
  set(folder DIRECTORY "${PROJECT_SOURCE_DIR}/${folder}")
  get_directory_property(is_found ${folder} DEFINITION ${name}_FOUND)
  get_directory_property(version ${folder} DEFINITION ${name}_VERSION)
  if(NOT version)
    get_directory_property(version ${folder} DEFINITION ${name}_VERSION_STRING)
  endif()
  if(is_found)
    list(APPEND components "{\"type\": \"library\", \"name\": \"${name}\", \"version\": \"${version}\", \
\"licenses\": [{\"license\": {\"id\": \"${licence}\"}}]}")
  endif()
endforeach()
list(JOIN components ",\n  " components)
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/sbom.cdx.json" @ONLY CONTENT
"{\"bomFormat\": \"CycloneDX\", \"specVersion\": \"1.5\", \"version\": 1,
 \"metadata\": {\"component\": {\"type\": \"application\", \"name\": \"mocapress\", \"version\": \"@PROJECT_VERSION@\"}},
 \"components\": [
  @components@
 ]}
")
include(GNUInstallDirs)
install(FILES "${PROJECT_BINARY_DIR}/sbom.cdx.json" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/mocapress")
