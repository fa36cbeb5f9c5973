# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
# cmake -DCOMPILER=... -DINCLUDE_DIRS=a;b -DSOURCE=x.cpp -P check_includes.cmake
cmake_minimum_required(VERSION 3.25)
list(REMOVE_DUPLICATES INCLUDE_DIRS)
list(TRANSFORM INCLUDE_DIRS PREPEND -I)
execute_process(COMMAND "${COMPILER}" -std=c++20 -M ${INCLUDE_DIRS} "${SOURCE}"
  RESULT_VARIABLE status OUTPUT_VARIABLE dependencies ERROR_VARIABLE messages)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${messages}")
endif()

string(REGEX REPLACE "[ \\\n]+" ";" dependencies "${dependencies}")
set(ours ${dependencies})
list(FILTER ours INCLUDE REGEX "/tensortopo/")
if(ours STREQUAL "")
  message(FATAL_ERROR "no header of ours was read")
endif()
list(FILTER dependencies EXCLUDE REGEX "/tensortopo/")
set(libraries "boost|CGAL|[Ee]igen|gmp|mpf|mpfr|mpfi|flint|arb|vtk|tbb|oneapi|fmt|pugixml|openssl")
list(FILTER dependencies INCLUDE REGEX "/(${libraries})[^/]*(/|\\.h)")
if(NOT dependencies STREQUAL "")
  list(SUBLIST dependencies 0 10 dependencies)
  list(JOIN dependencies "\n  " dependencies)
  message(FATAL_ERROR "headers for clients of double include\n  ${dependencies}")
endif()
