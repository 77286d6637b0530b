# SPDX-License-Identifier: BSD-3-Clause

function(narrows_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion
    $<$<BOOL:${NARROWS_WERROR}>:-Werror>)
endfunction()

# A library of ours: narrows_add_library(name HEADERS ... SOURCES ... DEPENDS ... PRIVATE_DEPENDS ... PRECOMPILE ...)
function(narrows_add_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS;SOURCES;DEPENDS;PRIVATE_DEPENDS;PRECOMPILE")
  add_library(narrows_${name} ${arg_SOURCES})  # static, unless BUILD_SHARED_LIBS says otherwise
  add_library(narrows::${name} ALIAS narrows_${name})
  set_target_properties(narrows_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} INSTALL_RPATH "$ORIGIN")
  target_sources(narrows_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/src FILES ${arg_HEADERS})
  target_link_libraries(narrows_${name} PUBLIC ${arg_DEPENDS} PRIVATE ${arg_PRIVATE_DEPENDS})
  if(arg_PRECOMPILE)
    target_precompile_headers(narrows_${name} PRIVATE ${arg_PRECOMPILE})
  endif()
  narrows_compile_options(narrows_${name})
endfunction()

# What tests include, compiled once: narrows_add_test_headers(name DEPENDS narrows::kernel ... HEADERS <x.h> ...)
function(narrows_add_test_headers name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "DEPENDS;HEADERS")
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(GENERATE OUTPUT ${source} CONTENT "// Headers only.\n")
  add_library(${name} OBJECT ${source})
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS} GTest::gmock)
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
  narrows_compile_options(${name})
endfunction()

# One test program per file: narrows_add_test(XTest DEPENDS narrows::kernel ... [SLOW])
# SLOW tests are left out of the sanitizer preset's run.
function(narrows_add_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "SLOW" "" "DEPENDS;SOURCES")
  add_executable(${name} ${name}.cpp ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_DEPENDS} GTest::gmock GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE NARROWS_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  if(arg_DEPENDS STREQUAL "narrows::kernel")
    target_precompile_headers(${name} REUSE_FROM narrows_kernel_test_headers)
  else()
    target_precompile_headers(${name} REUSE_FROM narrows_planning_test_headers)
  endif()
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
  narrows_compile_options(${name})
  set(label fast)
  if(arg_SLOW)
    set(label slow)
  endif()
  # Listing takes a tenth of a second; a busy machine's first look at a program on its disk has taken more than CMake's 5 s.
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 120 PROPERTIES LABELS ${label} TIMEOUT 600)
endfunction()

# CGAL for the named sources of a target only: narrows_use_cgal(target file.cpp ...). CGAL::CGAL would compile the whole
# target with -frounding-math, which costs every numerical loop in it.
function(narrows_use_cgal target)
  target_link_libraries(${target} PRIVATE gmpxx mpfr gmp)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_PRECOMPILE_HEADERS ON COMPILE_OPTIONS "-frounding-math;-DCGAL_USE_GMPXX=1")
endfunction()
