# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
# cmake -DCOMPILER=... "-DINCLUDE_DIRS=a;b" -DOWN=header -DUPWARD=header -DDIR=... -P this
# With the include directories of a folder its own header is found, and one of a folder above is
# not.
cmake_minimum_required(VERSION 3.25)
list(REMOVE_DUPLICATES INCLUDE_DIRS)
list(TRANSFORM INCLUDE_DIRS PREPEND -I)
foreach(kind OWN UPWARD)
  set(source "${DIR}/include_${kind}.cpp")
  file(WRITE "${source}" "#include \"${${kind}}\"\n")
  execute_process(COMMAND "${COMPILER}" -std=c++20 -M ${INCLUDE_DIRS} "${source}"
    RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE messages)
  if(kind STREQUAL "OWN" AND NOT status EQUAL 0)
    message(FATAL_ERROR "${OWN} is not found:\n${messages}")
  elseif(kind STREQUAL "UPWARD" AND status EQUAL 0)
    message(FATAL_ERROR "${UPWARD} is found")
  endif()
endforeach()
