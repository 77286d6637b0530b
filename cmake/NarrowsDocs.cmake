# SPDX-License-Identifier: BSD-3-Clause
# The target docs: pages of the public API by Doxygen, on which a symbol without a meaning is an error; its test Doxygen.
find_program(NARROWS_DOXYGEN doxygen)
if(NOT NARROWS_DOXYGEN)
  message(STATUS "No doxygen: no target docs")
  return()
endif()

foreach(library kernel planning scenario)  # what is installed
  get_target_property(headers narrows_${library} HEADER_SET)
  list(APPEND NARROWS_DOCUMENTED ${headers})
endforeach()
list(JOIN NARROWS_DOCUMENTED " " NARROWS_DOCUMENTED)
configure_file(${PROJECT_SOURCE_DIR}/docs/Doxyfile.in ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/docs)
add_custom_target(docs COMMAND ${NARROWS_DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile COMMENT "Pages of the public API" VERBATIM)
if(NARROWS_BUILD_TESTS)
  add_test(NAME Doxygen COMMAND ${NARROWS_DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile)
  set_tests_properties(Doxygen PROPERTIES LABELS fast TIMEOUT 600)
endif()
