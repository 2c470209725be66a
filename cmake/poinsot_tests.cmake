# How tests are registered, for CTest (scripts/test.sh) and for catkin's run_tests alike.
#
#   poinsot_gtest(NAME TIER quick|long SOURCES FILE... LIBRARIES LIBRARY... [DEPENDS TARGET...] [DEFINITIONS NAME=VALUE...]
#                 [DIRECTORIES DIRECTORY...] [ALONE])
#     A test program of Google Test that needs no ROS graph.
#   poinsot_rostest(FILE TIER quick|long [DEPENDS TARGET...] [ARGS NAME:=VALUE...] [ALONE | ALL_CORES])
#     A rostest file. It has its own master and, if it needs one, its own display.
#   poinsot_launch_files(DIRECTORY TIER quick|long [DEPENDS TARGET...])
#     The test launch_files: roslaunch can read the launch files of a directory and finds what they need.
#   poinsot_script(NAME TIER quick|long [ALONE | ALL_CORES] [IN_DEVEL] [STAGE NAME] COMMAND PROGRAM [ARGUMENT...]
#                  [DEPENDS TARGET...])
#     A program that prints a line "PASS  words" or "FAIL  words" for each check and ends with "N passed, M failed".
#     IN_DEVEL: it runs in the environment of the devel space.
#
# TIER: scripts/test.sh runs the quick tests; --all adds the long ones. DEPENDS: what has to be built besides the test.
# ALONE: the test measures time, or uses something of which there is only one, so nothing else runs meanwhile. ALL_CORES: it
# keeps all cores busy by itself. Each test NAME has a target needs_NAME, which builds just what the test needs.

# How CTest divides the machine: a test that computes takes one core, two that mostly wait share one.
set(POINSOT_SLOTS_A_CORE 2)
# s; far longer than any test takes beside others: ends a test that hangs.
set(POINSOT_TEST_TIMEOUT 1500)

# Usual durations, so that CTest begins with the longest tests.
file(STRINGS ${PROJECT_SOURCE_DIR}/test/durations.csv POINSOT_DURATIONS)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/test/durations.csv)

function(poinsot_register name ctest_name)
  cmake_parse_arguments(arg "ALONE;ALL_CORES" "TIER;STAGE;SLOTS" "DEPENDS" ${ARGN})
  if(NOT arg_TIER MATCHES "^(quick|long)$")
    message(FATAL_ERROR "test ${name}: expected TIER quick or TIER long, got TIER ${arg_TIER}")
  endif()
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "test ${name}: unexpected ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT TEST ${ctest_name})
    return()  # catkin registers no tests if testing is off
  endif()
  if(arg_ALL_CORES)
    set(arg_SLOTS 64)  # which CTest limits to the slots that there are
  endif()
  set_tests_properties(${ctest_name} PROPERTIES LABELS "${arg_TIER};${arg_STAGE}" PROCESSORS ${arg_SLOTS}
    RUN_SERIAL ${arg_ALONE} TIMEOUT ${POINSOT_TEST_TIMEOUT})
  foreach(row ${POINSOT_DURATIONS})
    if(row MATCHES "^([^,]+),[^,]*,([0-9.]+)$" AND CMAKE_MATCH_1 STREQUAL name)
      set_tests_properties(${ctest_name} PROPERTIES COST ${CMAKE_MATCH_2})
    endif()
  endforeach()
  string(REGEX REPLACE "[^A-Za-z0-9_.-]" "_" target ${name})
  add_custom_target(needs_${target})
  if(arg_DEPENDS)
    add_dependencies(needs_${target} ${arg_DEPENDS})
    add_dependencies(tests ${arg_DEPENDS})
  endif()
endfunction()

function(poinsot_gtest name)
  cmake_parse_arguments(arg "ALONE" "TIER" "SOURCES;LIBRARIES;DEPENDS;DEFINITIONS;DIRECTORIES" ${ARGN})
  catkin_add_executable_with_gtest(${name} EXCLUDE_FROM_ALL ${arg_SOURCES})
  if(NOT TARGET ${name})
    return()  # no Google Test
  endif()
  target_include_directories(${name} PRIVATE ${arg_DIRECTORIES})
  target_compile_definitions(${name} PRIVATE ${arg_DEFINITIONS})
  target_link_libraries(${name} ${arg_LIBRARIES})
  if(arg_DEPENDS)
    add_dependencies(${name} ${arg_DEPENDS})
  endif()
  add_dependencies(tests ${name})
  # Quoted, since catkin hands the command to a shell: the path may hold a blank.
  catkin_run_tests_target(gtest ${name} gtest-${name}.xml DEPENDENCIES ${name}
    COMMAND "\"${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_BIN_DESTINATION}/${name}\" \"--gtest_output=xml:${CATKIN_TEST_RESULTS_DIR}/${PROJECT_NAME}/gtest-${name}.xml\"")
  if(arg_ALONE)
    set(alone ALONE)
  endif()
  poinsot_register(${name} _ctest_${PROJECT_NAME}_gtest_${name} TIER ${arg_TIER} STAGE gtest
    SLOTS ${POINSOT_SLOTS_A_CORE} DEPENDS ${name} ${alone} ${arg_UNPARSED_ARGUMENTS})
endfunction()

# Like add_rostest() of rostest, but also for paths with a blank.
function(poinsot_rostest file)
  cmake_parse_arguments(arg "" "TIER" "ARGS;DEPENDS" ${ARGN})
  get_filename_component(path ${file} ABSOLUTE)
  file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR}/test ${path})
  string(REGEX REPLACE "\\.test$" "" name ${name})
  foreach(argument ${arg_ARGS})
    string(REPLACE ":=" "_" words ${argument})
    string(APPEND name "__${words}")
  endforeach()
  string(REPLACE "/" "_" name ${name})
  string(REPLACE ";" " " arguments "${arg_ARGS}")
  catkin_run_tests_target(rostest test_${name}.test rostest-test_${name}.xml DEPENDENCIES ${arg_DEPENDS}
    COMMAND "\"${PROJECT_SOURCE_DIR}/test/run_rostest.sh\" \"${CATKIN_TEST_RESULTS_DIR}\" \"--pkgdir=${PROJECT_SOURCE_DIR}\" --package=${PROJECT_NAME} --results-filename test_${name}.xml \"${path}\" ${arguments}")
  poinsot_register(${name}.test _ctest_${PROJECT_NAME}_rostest_test_${name}.test TIER ${arg_TIER} STAGE rostest
    SLOTS 1 DEPENDS ${arg_DEPENDS} ${arg_UNPARSED_ARGUMENTS})
endfunction()

# Like roslaunch_add_file_check() of roslaunch, which makes a directory outside the package if the path has a blank.
function(poinsot_launch_files directory)
  cmake_parse_arguments(arg "" "TIER" "DEPENDS" ${ARGN})
  set(result roslaunch-check_${directory}.xml)
  catkin_run_tests_target(roslaunch-check ${directory} ${result} DEPENDENCIES ${arg_DEPENDS}
    COMMAND "\"${PYTHON_EXECUTABLE}\" \"${roslaunch_DIR}/../scripts/roslaunch-check\" -o \"${CATKIN_TEST_RESULTS_DIR}/${PROJECT_NAME}/${result}\" \"${PROJECT_SOURCE_DIR}/${directory}\"")
  poinsot_register(launch_files _ctest_${PROJECT_NAME}_roslaunch-check_${directory} TIER ${arg_TIER} STAGE rostest
    SLOTS 1 DEPENDS ${arg_DEPENDS} ${arg_UNPARSED_ARGUMENTS})
endfunction()

function(poinsot_script name)
  cmake_parse_arguments(arg "IN_DEVEL" "TIER;STAGE" "COMMAND;DEPENDS" ${ARGN})
  if(arg_IN_DEVEL)
    set(environment ${CATKIN_ENV})
  endif()
  if(NOT arg_STAGE)
    set(arg_STAGE ${name})
  endif()
  add_test(NAME ${name} COMMAND ${environment} ${PYTHON_EXECUTABLE} ${PROJECT_SOURCE_DIR}/test/script_result.py
    ${CATKIN_TEST_RESULTS_DIR}/${PROJECT_NAME}/script-${name}.xml ${CMAKE_BINARY_DIR}/${name}.log ${arg_COMMAND})
  poinsot_register(${name} ${name} TIER ${arg_TIER} STAGE ${arg_STAGE} SLOTS ${POINSOT_SLOTS_A_CORE}
    DEPENDS ${arg_DEPENDS} ${arg_UNPARSED_ARGUMENTS})
endfunction()
