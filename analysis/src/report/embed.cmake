# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
# cmake -DFOLDER=page -DOUTPUT=page_sources.cpp -P embed.cmake: the page's files as strings of C++.
set(text "// Made of the files of page/.\n#include \"report/page_sources.hpp\"\n\nnamespace tensortopo::page_sources {\n\n")
foreach(entry "frame=report.html" "style=report.css" "scene_script=scene.js"
    "report_script=report.js")
  string(REGEX MATCH "^([^=]+)=(.+)$" matched "${entry}")
  set(name "${CMAKE_MATCH_1}")
  file(READ "${FOLDER}/${CMAKE_MATCH_2}" content)
  # A literal may have 65,535 characters at least; compilers here take more.
  string(APPEND text "const std::string_view ${name} = R\"~page~(${content})~page~\";\n\n")
endforeach()
string(APPEND text "}  // namespace tensortopo::page_sources\n")
file(WRITE "${OUTPUT}" "${text}")
