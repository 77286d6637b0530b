# SPDX-License-Identifier: BSD-3-Clause
# The target docs: pages of the public API by Doxygen, on which a symbol without a meaning is an error; its test Doxygen.
find_program(NARROWS_DOXYGEN doxygen)
if(NOT NARROWS_DOXYGEN)
  message(STATUS "No doxygen: no target docs")
  return()
endif()

# Headers that a program includes by name; what they include in turn is for reading in the sources.
set(NARROWS_DOCUMENTED
  kernel/ControlPoints.h kernel/PlanarArm.h kernel/PlanarModel.h kernel/PlanarObstacle.h kernel/PlanarRepulsionModel.h
  kernel/Repulsion.h kernel/SpatialArm.h kernel/SpatialModel.h kernel/SpatialRepulsionModel.h
  kernel/trajectory/JointTrajectory.h
  planners/HPPM.h planners/ModelPlanner.h planners/PlannerFactory.h planners/PlannerPlugin.h planners/Threader.h
  planners/TightManeuvering.h planners/VDSM.h planners/ViaPointHomotopy.h
  scenario/Problem.h scenario/Scenario.h
  spaces/ArmStateSpace.h spaces/JointStateSpace.h spaces/Ompl.h spaces/PlanarArmStateSpace.h
  spaces/SpatialArmStateSpace.h spaces/TipGoalRegion.h spaces/TipPathGoal.h
  validity/ArmChecker.h validity/ArmValidityChecker.h validity/ContinuousMotionValidator.h validity/Verifier.h)
list(TRANSFORM NARROWS_DOCUMENTED PREPEND "${PROJECT_SOURCE_DIR}/src/")
list(JOIN NARROWS_DOCUMENTED " " NARROWS_DOCUMENTED)
configure_file(${PROJECT_SOURCE_DIR}/docs/Doxyfile.in ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/docs)
add_custom_target(docs COMMAND ${NARROWS_DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile COMMENT "Pages of the public API" VERBATIM)
if(NARROWS_BUILD_TESTS)
  add_test(NAME Doxygen COMMAND ${NARROWS_DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile)
  set_tests_properties(Doxygen PROPERTIES LABELS fast TIMEOUT 600)
endif()
