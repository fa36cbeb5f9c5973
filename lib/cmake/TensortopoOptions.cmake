# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
# What a build can choose, and the flags that every target of ours shares.

option(TENSORTOPO_BUILD_ANALYSIS "Build the program tensortopo (needs VTK)" ${PROJECT_IS_TOP_LEVEL})
option(TENSORTOPO_BUILD_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(TENSORTOPO_WITH_CGAL_GPL
  "Build what needs packages of CGAL under the GPL: the program's jets, and oracles of tests" ON)
option(TENSORTOPO_INSTALL "Make install rules" ${PROJECT_IS_TOP_LEVEL})
option(TENSORTOPO_WERROR "Treat warnings in our own code as errors" ${PROJECT_IS_TOP_LEVEL})
# The distribution's Python comes with the headers and numpy that `.ci/install-packages` installs;
# another one is chosen by -DPython_EXECUTABLE=.
find_program(Python_EXECUTABLE python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module NumPy)
set(build_python OFF)
if(Python_FOUND)
  find_package(pybind11 2.10 QUIET CONFIG)
endif()
if(PROJECT_IS_TOP_LEVEL AND pybind11_FOUND AND NOT TENSORTOPO_SANITIZE)
  set(build_python ON)
endif()
option(TENSORTOPO_BUILD_PYTHON "Build the Python package (needs pybind11)" ${build_python})
option(TENSORTOPO_BUILD_FUZZERS "Build the fuzzers of readers (needs Clang)" OFF)
set(TENSORTOPO_SANITIZE "" CACHE STRING "Sanitizers for every target, e.g. address,undefined")

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

if(PROJECT_IS_TOP_LEVEL)
  find_program(TENSORTOPO_CCACHE ccache)
  if(TENSORTOPO_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${TENSORTOPO_CCACHE})
  endif()
endif()
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache$")
  # Not being told so, ccache compiles anew whatever uses precompiled headers.
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env
    CCACHE_SLOPPINESS=pch_defines,time_macros ${CMAKE_CXX_COMPILER_LAUNCHER})
endif()

# The language level and the arithmetic contract. Public: templates and inline functions are
# compiled in the client's flags, and an error bound proved without contraction does not hold with
# it.
add_library(tensortopo_fp INTERFACE)
add_library(tensortopo::fp ALIAS tensortopo_fp)
set_target_properties(tensortopo_fp PROPERTIES EXPORT_NAME fp)
target_compile_features(tensortopo_fp INTERFACE cxx_std_20)
target_compile_options(tensortopo_fp INTERFACE -ffp-contract=off)

# Warnings are for our own sources only, so this target is linked privately and never exported.
add_library(tensortopo_warnings INTERFACE)
target_compile_options(tensortopo_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor
  # GCC 12 believes that short strings overlap themselves (its bug 105329).
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>
  $<$<BOOL:${TENSORTOPO_WERROR}>:-Werror>)

# GCC 12 takes strings of precompiled headers for smaller objects of ours and warns of overflows.
# Builds without precompiled headers (preset dev) keep the warnings.
if(NOT CMAKE_DISABLE_PRECOMPILE_HEADERS AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND
   CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  target_compile_options(tensortopo_warnings INTERFACE
    -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
endif()

# tensortopo_headers(NAME HEADERS h... [LIBRARIES target...] [OPTIONS o...])
# Headers compiled once, for REUSE_FROM by targets of equal flags and definitions. The compiler
# refuses them to others for most differences, but not for -frounding-math or -O1 instead of -O3.
function(tensortopo_headers name)
  cmake_parse_arguments(arg "" "" "HEADERS;LIBRARIES;OPTIONS" ${ARGN})
  set(empty "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
  file(CONFIGURE OUTPUT "${empty}" CONTENT "// Precompiled headers want a source.\n")
  add_library(${name} OBJECT "${empty}")
  target_compile_options(${name} PRIVATE ${arg_OPTIONS})
  target_link_libraries(${name} PRIVATE tensortopo::fp tensortopo_warnings ${arg_LIBRARIES})
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
endfunction()

# tensortopo_in_batches(TARGET...)
# Compiles as many sources at a time as CMAKE_UNITY_BUILD_BATCH_SIZE says. What headers of inline
# functions ask for (JSON, RapidCheck, CLI11) is instantiated in every source that includes them,
# precompiled or not, and takes half the time of a small one. Builds without precompiled headers
# compile each source by itself.
function(tensortopo_in_batches)
  if(NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
    set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ON)
    # A batch includes its sources, whose anonymous namespaces GCC then takes for those of headers.
    foreach(target IN LISTS ARGN)
      target_compile_options(${target} PRIVATE
        $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
    endforeach()
  endif()
endfunction()

if(TENSORTOPO_SANITIZE)
  add_compile_definitions(TENSORTOPO_ASSERTIONS)
  add_compile_options(-fsanitize=${TENSORTOPO_SANITIZE} -fno-omit-frame-pointer
    -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${TENSORTOPO_SANITIZE})
  if(TENSORTOPO_SANITIZE MATCHES "thread")
    # Threads that the sanitizer understands, in place of TBB's.
    include_directories(BEFORE "${PROJECT_SOURCE_DIR}/tests/sanitizers/threads")
  endif()
endif()
