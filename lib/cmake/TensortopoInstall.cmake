# SPDX-FileCopyrightText: the tensortopo authors
# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` puts where, and the package that find_package(tensortopo) reads.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/tensortopo")
get_property(core_targets GLOBAL PROPERTY TENSORTOPO_CORE_TARGETS)

install(TARGETS tensortopo_fp tensortopo_tensortopo EXPORT tensortopoTargets)
install(TARGETS ${core_targets} EXPORT tensortopoTargets FILE_SET HEADERS)
install(EXPORT tensortopoTargets NAMESPACE tensortopo:: DESTINATION "${package_dir}")
if(TARGET tensortopo_io)
  # A package of its own within the package, so that only those who ask for it look for VTK.
  install(TARGETS tensortopo_io tensortopo_vtk EXPORT tensortopoIoTargets FILE_SET HEADERS)
  install(EXPORT tensortopoIoTargets NAMESPACE tensortopo:: DESTINATION "${package_dir}")
endif()

configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/tensortopoConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/tensortopoConfig.cmake"
  INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/tensortopoConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/tensortopoConfig.cmake"
  "${PROJECT_BINARY_DIR}/tensortopoConfigVersion.cmake"
  DESTINATION "${package_dir}")

# Debian packages: cpack --config build/release/CPackConfig.cmake -G DEB. Of components, so far the
# Python package alone.
if(PROJECT_IS_TOP_LEVEL AND TENSORTOPO_BUILD_PYTHON)
  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGE_CONTACT "the tensortopo authors")
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_COMPONENTS_ALL python)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-tensortopo)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${next_minor}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-meshio")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION
    "Mode surfaces and degenerate curves of piecewise linear fields, from numpy arrays to numpy arrays, with certificates and their checker.")
  set(CPACK_STRIP_FILES ON)
  include(CPack)
endif()
