# SPDX-License-Identifier: BSD-3-Clause
# cmake --install, find_package(narrows), pkg-config and the Debian packages libnarrows-dev (headers, libraries, package
# files) and narrows (the program). Included last, when all targets exist.
include(CMakePackageConfigHelpers)

set(NARROWS_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/narrows)
install(TARGETS narrows_kernel narrows_planning narrows_scenario EXPORT narrowsTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/narrows COMPONENT dev)
if(NARROWS_BUILD_PROGRAM)
  install(TARGETS narrows RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  if(BUILD_SHARED_LIBS)  # the program finds its libraries wherever the whole tree is put
    file(RELATIVE_PATH way_to_libraries /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
    set_target_properties(narrows PROPERTIES INSTALL_RPATH "$ORIGIN/${way_to_libraries}")
    install(TARGETS narrows_benchmark LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT program NAMELINK_SKIP)
  endif()
endif()
install(EXPORT narrowsTargets NAMESPACE narrows:: DESTINATION ${NARROWS_CMAKE_DIR} COMPONENT dev)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/narrowsConfig.cmake.in
  ${PROJECT_BINARY_DIR}/narrowsConfig.cmake INSTALL_DESTINATION ${NARROWS_CMAKE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/narrowsConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/narrowsConfig.cmake ${PROJECT_BINARY_DIR}/narrowsConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/OmplTarget.cmake DESTINATION ${NARROWS_CMAKE_DIR} COMPONENT dev)

# A package goes to another prefix than an installed tree.
file(RELATIVE_PATH NARROWS_WAY_TO_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${CMAKE_CURRENT_LIST_DIR}/narrows.pc.in ${PROJECT_BINARY_DIR}/narrows.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/narrows.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The authors of Narrows <narrows@localhost>")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_COMPONENTS_ALL dev program)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libnarrows-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
  "libeigen3-dev, libompl-dev, libfcl-dev, libfmt-dev, libnlopt-cxx-dev, libyaml-cpp-dev, libboost-filesystem-dev, libboost-serialization-dev, libboost-system-dev, libgmp-dev, libmpfr-dev")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME narrows)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
include(CPack)
