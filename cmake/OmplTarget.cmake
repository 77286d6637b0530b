# SPDX-License-Identifier: BSD-3-Clause
# OMPL 2 exports ompl::ompl; Debian's 1.5.2 only sets variables, among them the simulator ODE, which we do not use.
if(NOT TARGET ompl::ompl)
  find_library(NARROWS_OMPL_LIBRARY ompl HINTS ${OMPL_LIBRARY_DIRS} REQUIRED)
  add_library(ompl::ompl INTERFACE IMPORTED)
  target_include_directories(ompl::ompl INTERFACE ${OMPL_INCLUDE_DIRS})
  target_link_libraries(ompl::ompl INTERFACE ${NARROWS_OMPL_LIBRARY} Eigen3::Eigen Boost::serialization Boost::filesystem Boost::system)
endif()
