# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
# cmake -DKERNEL=folder -P check_kernel.cmake
# The kernel has at most 2,000 lines without comments and blank ones, and includes GMP, the standard
# library and itself only; no files, streams, threads or processes.
cmake_minimum_required(VERSION 3.25)
file(GLOB sources "${KERNEL}/*.hpp" "${KERNEL}/*.cpp")
set(count 0)
foreach(source IN LISTS sources)
  file(READ "${source}" text)
  string(REGEX REPLACE "[][;]" " " text "${text}")
  string(REGEX REPLACE "\\\\\n" " " text "${text}")
  string(REPLACE "\n" ";" lines "${text}")
  foreach(line IN LISTS lines)
    string(STRIP "${line}" line)
    if(line STREQUAL "" OR line MATCHES "^//")
      continue()
    endif()
    math(EXPR count "${count} + 1")
    if(line MATCHES "^#include <([^>]*)>")
      if(NOT CMAKE_MATCH_1 MATCHES "^(gmpxx\\.h|[a-z_]+)$" OR
         CMAKE_MATCH_1 MATCHES "stream|thread|filesystem|mutex|cstdio|future")
        message(SEND_ERROR "${source} includes ${CMAKE_MATCH_1}")
      endif()
    elseif(line MATCHES "^#include \"([^\"]*)\"" AND NOT EXISTS "${KERNEL}/${CMAKE_MATCH_1}")
      message(SEND_ERROR "${source} includes ${CMAKE_MATCH_1}, which is not of the kernel")
    endif()
  endforeach()
endforeach()
if(count EQUAL 0 OR count GREATER 2000)
  message(SEND_ERROR "the kernel has ${count} lines, not 1 to 2,000")
endif()
message("${count} lines")
