# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
# cmake -D SOURCE=FOLDER -P check_counts.cmake: does the README of FOLDER count statements, steps and
# theorems as theory/README.md, proofs-check/STEPS.md and proofs-check/coq/statements.txt do?
file(READ "${SOURCE}/theory/README.md" theory)
file(READ "${SOURCE}/proofs-check/STEPS.md" steps)
file(STRINGS "${SOURCE}/proofs-check/coq/statements.txt" theorems REGEX "^[a-z].*\\|")
list(LENGTH theorems of_coq)

if(NOT theory MATCHES "([0-9]+) statements: ([0-9]+) of the paper, of which ([0-9]+) are corrected, and ([0-9]+) of ours")
  message(FATAL_ERROR "theory/README.md does not count its statements")
endif()
set(all ${CMAKE_MATCH_1})
set(printed ${CMAKE_MATCH_2})
set(corrected ${CMAKE_MATCH_3})
set(ours ${CMAKE_MATCH_4})
if(NOT theory MATCHES "([0-9]+) have theorems in Coq, ([0-9]+) have exact steps, all are tried; in ([0-9]+) something is left to a reader")
  message(FATAL_ERROR "theory/README.md does not say how its statements are established")
endif()
set(with_theorems ${CMAKE_MATCH_1})
set(with_steps ${CMAKE_MATCH_2})
set(with_reader ${CMAKE_MATCH_3})
if(NOT steps MATCHES "([0-9]+) steps: [0-9]+ holds, ([0-9]+) corrected, 0 refuted, 0 undecided")
  message(FATAL_ERROR "proofs-check/STEPS.md does not count its steps, or some are open")
endif()
set(number_of_steps ${CMAKE_MATCH_1})
set(corrected_steps ${CMAKE_MATCH_2})

file(READ "${SOURCE}/README.md" page)
string(REGEX REPLACE "[ \n]+" " " page "${page}")
foreach(wanted IN ITEMS
    "${corrected} of ${printed} statements and ${corrected_steps} of ${number_of_steps} steps of proofs need a correction"
    "Of all ${all} statements, ${ours} of them ours, ${with_theorems} have theorems that Coq has checked (${of_coq}), ${with_steps} have exact steps, all are tried, and ${with_reader} leave something to a reader.")
  string(FIND "${page}" "${wanted}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "README.md should say: ${wanted}")
  endif()
endforeach()
