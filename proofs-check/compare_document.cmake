# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
# cmake -D PROGRAM=tensortopo_proofs -D DOCUMENT=STEPS.md -P: is the document what the program says?
execute_process(COMMAND "${PROGRAM}" --markdown OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
file(READ "${DOCUMENT}" written)
if(NOT said STREQUAL written)
  message(FATAL_ERROR "${DOCUMENT} is out of date; write it anew: ${PROGRAM} --markdown")
endif()
