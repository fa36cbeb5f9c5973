# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
# cmake -DCOMPILER=... -DINCLUDE_DIRS=a;b -DSOURCE=x.cpp -P check.cmake
cmake_minimum_required(VERSION 3.25)
set(ENV{LC_ALL} C)
list(REMOVE_DUPLICATES INCLUDE_DIRS)
list(TRANSFORM INCLUDE_DIRS PREPEND -I)
set(compile "${COMPILER}" -std=c++20 -fsyntax-only ${INCLUDE_DIRS})

file(STRINGS "${SOURCE}" expected REGEX "^// Expect: ")
string(REGEX REPLACE "^// Expect: " "" expected "${expected}")
if(expected STREQUAL "")
  message(FATAL_ERROR "${SOURCE} does not say what the compiler should object to")
endif()

execute_process(COMMAND ${compile} "${SOURCE}"
  RESULT_VARIABLE status ERROR_VARIABLE messages)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the twin does not compile:\n${messages}")
endif()

execute_process(COMMAND ${compile} -DMUST_NOT_COMPILE "${SOURCE}"
  RESULT_VARIABLE status ERROR_VARIABLE messages)
if(status EQUAL 0)
  message(FATAL_ERROR "it compiles")
endif()
if(NOT messages MATCHES "${expected}")
  message(FATAL_ERROR "it is refused, but not with '${expected}':\n${messages}")
endif()

file(STRINGS "${SOURCE}" lines)
set(number 0)
foreach(line IN LISTS lines)
  math(EXPR number "${number} + 1")
  if(line MATCHES "// refused$" AND NOT messages MATCHES ":${number}:[0-9]+: error: ")
    message(FATAL_ERROR "line ${number} is not refused:\n${messages}")
  endif()
endforeach()
