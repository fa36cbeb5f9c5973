# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
# Debian packages of what is built: cpack --config build/release/CPackConfig.cmake -G DEB. One for
# each component of the installation: the program, development files, the Python package, the plugin
# of ParaView (if analysis/paraview/build has made it) and the site (if .docs/make has).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the tensortopo authors <authors@tensortopo.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program dev)

set(packaging "${PROJECT_SOURCE_DIR}/.packaging")
set(changelog "${PROJECT_BINARY_DIR}/changelog.Debian.gz")
execute_process(COMMAND gzip -9nc "${packaging}/changelog" OUTPUT_FILE "${changelog}"
  COMMAND_ERROR_IS_FATAL ANY)

# tensortopo_package(COMPONENT NAME SECTION SUMMARY DESCRIPTION [DEPENDS d] [SUGGESTS s] [ALL])
macro(tensortopo_package component name section summary description)
  cmake_parse_arguments(package "ALL" "DEPENDS;SUGGESTS" "" ${ARGN})
  string(TOUPPER "${component}" upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME "${name}")
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION "${section}")
  set(CPACK_DEBIAN_${upper}_DESCRIPTION "${summary}\n${description}")
  if(package_DEPENDS)
    set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${package_DEPENDS}")
  endif()
  if(package_SUGGESTS)
    set(CPACK_DEBIAN_${upper}_PACKAGE_SUGGESTS "${package_SUGGESTS}")
  endif()
  if(package_ALL)
    set(CPACK_DEBIAN_${upper}_PACKAGE_ARCHITECTURE all)
    set(CPACK_DEBIAN_${upper}_PACKAGE_SHLIBDEPS OFF)
  endif()
  # Debian's rules want both in each package; an installation by `cmake --install` goes without.
  install(FILES "${packaging}/copyright" "${changelog}" DESTINATION "share/doc/${name}"
    COMPONENT ${component} EXCLUDE_FROM_ALL)
endmacro()

tensortopo_package(program tensortopo science
  "certified topology of 3D symmetric tensor fields"
  "Mode surfaces, neutral surfaces and degenerate curves of stress, diffusion
and other symmetric tensor fields that are linear in tetrahedra. Every edge,
face and tetrahedron is decided by exact signs; certificates are checked by
a program of its own."
  SUGGESTS "tensortopo-doc, xvfb, ffmpeg")
install(CODE "
  set(pages \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/share/man/man1\")
  execute_process(COMMAND gzip -9nc \"${packaging}/tensortopo_check.1\"
    OUTPUT_FILE \"\${pages}/tensortopo_check.1.gz\" COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND gzip -9nf \"\${pages}/tensortopo.1\" COMMAND_ERROR_IS_FATAL ANY)"
  COMPONENT program EXCLUDE_FROM_ALL)

tensortopo_package(dev libtensortopo-dev libdevel
  "certified topology of 3D symmetric tensor fields (development files)"
  "Headers, static libraries and CMake files of tensortopo, for
find_package(tensortopo). The component io needs VTK as well."
  DEPENDS "libboost-dev, libcgal-dev, libeigen3-dev, libgmp-dev, libmpfr-dev, libssl-dev, libtbb-dev"
  SUGGESTS "libdeflate-dev, libfmt-dev, libpugixml-dev, libvtk9-dev, tensortopo-doc")

if(TENSORTOPO_BUILD_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(python "${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}")
  tensortopo_package(python python3-tensortopo python
    "certified topology of 3D symmetric tensor fields (Python)"
    "Mode surfaces and degenerate curves of piecewise linear fields, from numpy
arrays to numpy arrays, with certificates and their checker. It links
nothing of VTK."
    DEPENDS "python3 (>= ${python}), python3 (<< ${Python_VERSION_MAJOR}.${next_minor}), python3-numpy"
    SUGGESTS "python3-meshio, tensortopo, tensortopo-doc")
endif()

tensortopo_package(paraview tensortopo-paraview science
  "certified topology of 3D symmetric tensor fields (ParaView plugin)"
  "Filters of ParaView that extract mode surfaces and degenerate curves, in the
menu Tensor topology. Load the plugin TensorTopo.so in Tools, Manage
Plugins."
  DEPENDS "paraview" SUGGESTS "tensortopo-doc")
tensortopo_package(doc tensortopo-doc doc
  "certified topology of 3D symmetric tensor fields (documentation)"
  "Tutorials, how-tos, the reference of the command line, of Python and of C++,
the format of certificates, and the theory, as pages for a browser."
  ALL)
install(DIRECTORY "${PROJECT_BINARY_DIR}/site/html" DESTINATION share/doc/tensortopo-doc
  COMPONENT doc EXCLUDE_FROM_ALL PATTERN .buildinfo EXCLUDE)

# What is there when cpack runs.
file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/what_is_built.cmake" CONTENT [[
if(EXISTS "@PROJECT_BINARY_DIR@/site/html/index.html")
  list(APPEND CPACK_COMPONENTS_ALL doc)
endif()
if(EXISTS "@PROJECT_SOURCE_DIR@/build/paraview/cmake_install.cmake")
  list(APPEND CPACK_COMPONENTS_ALL paraview)
  list(APPEND CPACK_INSTALL_CMAKE_PROJECTS
    "@PROJECT_SOURCE_DIR@/build/paraview" tensortopo_paraview ALL /)
endif()
]] @ONLY)
set(CPACK_PROJECT_CONFIG_FILE "${PROJECT_BINARY_DIR}/what_is_built.cmake")
include(CPack)
