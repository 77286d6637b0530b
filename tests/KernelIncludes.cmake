# SPDX-License-Identifier: BSD-3-Clause
# Fails if a file of the kernel includes what it must not know: anything but Eigen, the standard library without files,
# clocks, printing and randomness, and the kernel itself. Run as: cmake -D SOURCE=... -P KernelIncludes.cmake
file(GLOB_RECURSE files ${SOURCE}/src/kernel/*.h ${SOURCE}/src/kernel/*.cpp)
list(LENGTH files count)
if(count LESS 10)
  message(FATAL_ERROR "only ${count} kernel files found below ${SOURCE}: is the path right?")
endif()
set(offences "")
foreach(path IN LISTS files)
  file(STRINGS ${path} lines REGEX "^ *# *include")
  foreach(line IN LISTS lines)
    if(line MATCHES "<(fstream|iostream|filesystem|chrono|random|cstdio|ctime|thread)>" OR
       NOT line MATCHES "\"kernel/|<Eigen/|<[a-z_]+>")
      string(APPEND offences "\n  ${path}: ${line}")
    endif()
  endforeach()
endforeach()
if(offences)
  message(FATAL_ERROR "src/kernel includes what it must not know:${offences}")
endif()
