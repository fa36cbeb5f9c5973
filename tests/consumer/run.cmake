# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
# cmake -DHOW=find_package|find_package_with_io|add_subdirectory|proofs_check -D...
# (see CMakeLists.txt) -P run.cmake
cmake_minimum_required(VERSION 3.25)
set(program consumer)
set(build "${WORK_DIR}/${HOW}")
set(prefix "${build}/prefix")
file(REMOVE_RECURSE "${build}")

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(options "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}"
  "-DCMAKE_CXX_FLAGS=${FLAGS}" "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}")
if(HOW STREQUAL "proofs_check")
  run("${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${SOURCE_DIR}/proofs-check" -B "${build}" ${options})
  run("${CMAKE_COMMAND}" --build "${build}" --target ${TARGET})
  return()
endif()
if(HOW MATCHES "find_package")
  run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${prefix}")
  # What is installed stands alone: no file names the place where it was made.
  file(GLOB_RECURSE scripts "${prefix}/*.cmake")
  foreach(script IN LISTS scripts)
    file(STRINGS "${script}" lines REGEX "tensortopo_warnings")
    file(READ "${script}" text)
    string(FIND "${text}" "${SOURCE_DIR}" at)
    if(lines OR NOT at EQUAL -1)
      message(FATAL_ERROR "${script} mentions what is not installed")
    endif()
  endforeach()
  list(APPEND options "-DCMAKE_PREFIX_PATH=${prefix}")
  # A component that is not there is named, with what can be done.
  execute_process(COMMAND "${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${CMAKE_CURRENT_LIST_DIR}/project"
      -B "${build}/without" ${options} -DTENSORTOPO_COMPONENTS=nonsense
    RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE message)
  string(REGEX REPLACE "[ \n]+" " " message "${message}")
  if(status EQUAL 0 OR NOT message MATCHES "has no component nonsense: known is io")
    message(FATAL_ERROR "a missing component is not explained: ${message}")
  endif()
  # The program's manual page and completion are installed with it.
  if(EXISTS "${prefix}/bin/tensortopo")
    foreach(file IN ITEMS share/man/man1/tensortopo.1
        share/bash-completion/completions/tensortopo share/tensortopo/schema/extract.json)
      if(NOT EXISTS "${prefix}/${file}")
        message(FATAL_ERROR "${file} is not installed")
      endif()
    endforeach()
  endif()
  if(HOW STREQUAL "find_package_with_io")
    list(APPEND options -DTENSORTOPO_COMPONENTS=io)
    set(program consumer_io)
  endif()
else()
  list(APPEND options "-DTENSORTOPO_SOURCE_DIR=${SOURCE_DIR}")
endif()

run("${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${CMAKE_CURRENT_LIST_DIR}/project" -B "${build}"
  ${options})
if(CONFIGURE_ONLY)
  return()
endif()
run("${CMAKE_COMMAND}" --build "${build}" --target ${program})
run("${build}/${program}")
# The checker is installed, too, and finds a certificate right that was made from C++.
if(HOW STREQUAL "find_package_with_io")
  run("${CMAKE_COMMAND}" --build "${build}" --target consumer_certificate)
  run("${build}/consumer_certificate" "${build}")
  run("${prefix}/bin/tensortopo_check" "${build}/field.vtu" "${build}/surface.vtp"
    "${build}/certificate.json")
endif()
