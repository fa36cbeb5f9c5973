# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0

# tensortopo_module(NAME HEADERS h... SOURCES s... [ROUNDING_SOURCES s...] [PUBLIC target...]
#   [PRIVATE target...] [REUSE_PRECOMPILED_NUMBERS] [LIGHTLY_OPTIMISED])
# One folder of lib as one target tensortopo::NAME. Headers are named relative to
# include/tensortopo/NAME, sources relative to src. ROUNDING_SOURCES compute with directed rounding,
# of intervals of doubles mostly. REUSE_PRECOMPILED_NUMBERS is for targets whose flags are those of
# tensortopo_scalar, which makes the precompiled headers. LIGHTLY_OPTIMISED targets are not worth much
# of the optimiser's time.
function(tensortopo_module name)
  cmake_parse_arguments(arg "REUSE_PRECOMPILED_NUMBERS;LIGHTLY_OPTIMISED" ""
    "HEADERS;SOURCES;ROUNDING_SOURCES;PUBLIC;PRIVATE" ${ARGN})
  set(target tensortopo_${name})
  list(TRANSFORM arg_HEADERS PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/include/tensortopo/${name}/")
  list(TRANSFORM arg_SOURCES PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/src/")
  list(TRANSFORM arg_ROUNDING_SOURCES PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/src/")
  if(arg_SOURCES)
    add_library(${target} STATIC ${arg_SOURCES})
    set(scope PUBLIC)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:tensortopo_warnings> ${arg_PRIVATE})
    tensortopo_in_batches(${target})
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(tensortopo::${name} ALIAS ${target})
  target_sources(${target} ${scope} FILE_SET HEADERS
    BASE_DIRS "${CMAKE_CURRENT_SOURCE_DIR}/include" FILES ${arg_HEADERS})
  target_link_libraries(${target} ${scope} tensortopo::fp ${arg_PUBLIC})
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${name}
    POSITION_INDEPENDENT_CODE ON
    VERIFY_INTERFACE_HEADER_SETS ${PROJECT_IS_TOP_LEVEL})
  set_property(GLOBAL APPEND PROPERTY TENSORTOPO_TARGETS ${target})
  if(arg_LIGHTLY_OPTIMISED)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()

  if(arg_ROUNDING_SOURCES)
    # A target of its own, because precompiled headers hold for equal flags only.
    add_library(${target}_rounding OBJECT ${arg_ROUNDING_SOURCES})
    target_include_directories(${target}_rounding PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/include")
    target_compile_options(${target}_rounding PRIVATE -frounding-math)
    target_link_libraries(${target}_rounding PRIVATE
      tensortopo::fp $<BUILD_INTERFACE:tensortopo_warnings> ${arg_PUBLIC} ${arg_PRIVATE})
    set_target_properties(${target}_rounding PROPERTIES POSITION_INDEPENDENT_CODE ON)
    tensortopo_in_batches(${target}_rounding)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${target}_rounding>)
  endif()
  if(arg_REUSE_PRECOMPILED_NUMBERS)
    target_precompile_headers(${target} REUSE_FROM tensortopo_scalar)
    if(TARGET ${target}_rounding)
      target_precompile_headers(${target}_rounding REUSE_FROM tensortopo_scalar_rounding)
    endif()
  endif()
endfunction()
