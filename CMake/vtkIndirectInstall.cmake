# Files that `cmake --install` installs besides the modules: the package files with which
# other projects find them. The Python package installs itself (Wrapping/Python).
include(CMakePackageConfigHelpers)

set(vtk_indirect_cmake_dir "${CMAKE_INSTALL_LIBDIR}/cmake/vtkIndirect")

# Everything of VTK that the modules name, publicly or privately: linkers want to see it all.
set(vtk_indirect_vtk_components)
foreach (module IN LISTS vtk_indirect_modules)
  foreach (kind IN ITEMS depends private_depends)
    get_property(depends TARGET "${module}" PROPERTY "INTERFACE_vtk_module_${kind}")
    list(APPEND vtk_indirect_vtk_components ${depends})
  endforeach ()
endforeach ()
list(REMOVE_DUPLICATES vtk_indirect_vtk_components)
list(REMOVE_ITEM vtk_indirect_vtk_components ${vtk_indirect_modules})
list(TRANSFORM vtk_indirect_vtk_components REPLACE "^VTK::" "")
list(SORT vtk_indirect_vtk_components)
list(JOIN vtk_indirect_vtk_components " " vtk_indirect_vtk_components)

configure_package_config_file(
  "${CMAKE_CURRENT_SOURCE_DIR}/CMake/vtkIndirectConfig.cmake.in"
  "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/vtkIndirectConfig.cmake"
  INSTALL_DESTINATION "${vtk_indirect_cmake_dir}"
  PATH_VARS CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_LIBDIR
  NO_SET_AND_CHECK_MACRO)
# No promises between minor versions yet.
write_basic_package_version_file(
  "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/vtkIndirectConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(
  FILES
    "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/vtkIndirectConfig.cmake"
    "${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/vtkIndirectConfigVersion.cmake"
  DESTINATION "${vtk_indirect_cmake_dir}"
  COMPONENT development)
install(
  FILES "${CMAKE_CURRENT_SOURCE_DIR}/LICENSE"
  DESTINATION "${CMAKE_INSTALL_DOCDIR}"
  COMPONENT runtime)
