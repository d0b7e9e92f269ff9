# `cpack` makes two Debian packages: pantin, and libpantin-dev.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the Pantin authors <authors@pantin.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "physics engine to play with, scripted in Lua")
set(CPACK_COMPONENTS_ALL program library)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME pantin)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
    "Scenes of hinged bodies, of things that touch and of particles with laws\nof one's own: open them in a window and drag them about, run and test them\nwithout one, film them, and sweep over their parameters.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# What is opened while it runs; the rest is what it is linked with.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "libegl1, libgl1")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "libgl1-mesa-dri, fonts-dejavu-core, ffmpeg")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libpantin-dev)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION
    "Headers, and libraries to link statically: the engine (CMake target\npantin::engine, pkg-config pantin), and scenes in Lua over it (pantin::lua,\npantin-lua).")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "libtbb-dev, libsleef-dev, libqhull-dev, liblua5.4-dev, pkg-config")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_RECOMMENDS pantin)

configure_file(changelog.in changelog @ONLY)
foreach(part program library)
  set(documents ${CMAKE_INSTALL_DATADIR}/doc/$<IF:$<STREQUAL:${part},program>,pantin,libpantin-dev>)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright DESTINATION ${documents} COMPONENT ${part})
  install(CODE "
    execute_process(COMMAND gzip -9nc ${CMAKE_CURRENT_BINARY_DIR}/changelog OUTPUT_FILE ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz
                    COMMAND_ERROR_IS_FATAL ANY)
  " COMPONENT ${part})
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz DESTINATION ${documents} COMPONENT ${part})
endforeach()
install(FILES lintian-overrides RENAME libpantin-dev DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides COMPONENT library)
include(CPack)
