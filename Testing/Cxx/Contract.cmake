# Contract tests: guarantees of the passes for VTK and its users, apart from the light itself. Each
# runs in its own process.
if (NOT TARGET VTK::IndirectHeadless)
  message(STATUS "Contract and image tests: off, they need VTK::IndirectHeadless")
  return ()
endif ()
file(GLOB contract_sources CONFIGURE_DEPENDS "*/TestPass*.cxx")

vtk_module_test_executable(TestPassContract
  Harness/vtkIndirectContractKinds.cxx
  Harness/vtkIndirectContractMain.cxx
  Harness/vtkIndirectContractReport.cxx
  Harness/vtkIndirectContractScenes.cxx
  Harness/vtkIndirectContractUtilities.cxx
  Harness/vtkIndirectGLNames.cxx
  Harness/vtkIndirectHarness.cxx
  ${contract_sources})
target_link_libraries(TestPassContract
  PRIVATE
    VTK::IndirectHeadless
    VTK::IndirectOracle
    nlohmann_json::nlohmann_json
    # The loader through which VTK calls OpenGL: one of the two, by VTK's version.
    $<TARGET_NAME_IF_EXISTS:VTK::glew>
    $<TARGET_NAME_IF_EXISTS:VTK::glad>
    $<TARGET_NAME_IF_EXISTS:OpenGL::OpenGL>)
target_include_directories(TestPassContract PRIVATE Harness "${module_dir}/Private")
vtk_indirect_compile_options(TestPassContract)
set_source_files_properties(Plan/TestPassReport.cxx PROPERTIES
  COMPILE_DEFINITIONS "VTK_INDIRECT_TEST_FOLDER=\"${CMAKE_CURRENT_BINARY_DIR}\"")

vtk_indirect_add_tests(TestPassContract PREFIX Contract LABEL contract SOURCES ${contract_sources}
  FAIL_ON "ERROR: ")
# Mesa simulates an older OpenGL.
set_property(TEST Contract.ChoicesOpenGL32 Contract.ReportClocksOpenGL32 Contract.ReportClocksNone
  APPEND PROPERTY ENVIRONMENT "MESA_GL_VERSION_OVERRIDE=3.2")
set_property(TEST Contract.ReportClocksNone
  APPEND PROPERTY ENVIRONMENT "MESA_EXTENSION_OVERRIDE=-GL_ARB_timer_query")
