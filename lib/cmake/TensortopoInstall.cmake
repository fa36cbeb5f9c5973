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

if(PROJECT_IS_TOP_LEVEL)
  include(TensortopoPackages)
endif()
