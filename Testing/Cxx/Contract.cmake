# Contract tests: what VTK and its users may expect of the passes, apart from the light itself. Each
# runs in a process of its own.
if (NOT TARGET VTK::IndirectHeadless)
  message(STATUS "Contract and image tests: off, they need VTK::IndirectHeadless")
  return ()
endif ()
set(contract_sources)
set(contract_tests)

# Adds TestPass<topic>.cxx with the tests that it defines.
macro (contract_topic topic)
  list(APPEND contract_sources "TestPass${topic}.cxx")
  list(APPEND contract_tests ${ARGN})
endmacro ()

contract_topic(Shadows
  ShadowPosition ShadowDistance ShadowAspect ShadowNoSelf ShadowNoSelfScales)
contract_topic(Viewports
  ViewportsFour ViewportsOnePass ViewportsNeighbors ViewportOrigin LayersOver LayersPreserve Tiles
  Resize StereoEyes)
contract_topic(Composition
  TranslucentBlend TranslucentPeeling Volumes Overlay Backgrounds AntialiasingFXAA
  AntialiasingFXAAPass AntialiasingSSAAPass)
contract_topic(Interaction
  SelectionSame PickingSame DepthSame DepthOfBackground StateUntouched BlendingRemembered)
contract_topic(Kinds
  KindsDelegate KindsComposite KindsFull AlbedoValues SurfaceBuffers)
contract_topic(Buffers BuffersOfLastFrame)
contract_topic(Lifetime
  Toggle ToggleHints ToggleMultiresolution ToggleNewPass Release ReleaseMultiresolution Finalize
  FinalizeUnused FinalizeWithout DestructionOrder TwoWindows)
contract_topic(Release ReleaseWithoutWindow)
contract_topic(Lights
  LightShadowAttenuation LightColors LightSettings LightHeadlight LightOfCamera LightKit ShadowFollows
  ShadowFromOutside ShadowSeams ParallelEye)
contract_topic(Speed
  WorkNothingChanged WorkChanges WorkCameraLight WorkDraws ShaderBuilds FlatUniforms)
contract_topic(Props
  PropsSky PropsColorOnly PropsBillboard PropsSplats PropsLeftOut PropsHints)
contract_topic(Casters
  PropsTubes PropsBehindCasters PropsEdges PropsAnnotation PropsKeys)
contract_topic(Paths PathsSame PathsTake PathsKernels PathsErrors PathsOpenGL32)
contract_topic(Delegates DelegateRedirects DelegateItself DelegateSteps)
contract_topic(Errors
  DebugViewUnknown CopyBufferWrong StagesAlone ResolutionLimits MapsTooMany HintsTooMany
  HintsTooManyBlocks NothingToDo BadActors)
contract_topic(Print
  PrintSettings PrintCounters ReportStages)
contract_topic(Clocks ReportClocks ReportClocksOpenGL32 ReportClocksNone ReleaseQueries)
contract_topic(Report
  ReportReader ReportGrid ReportTolerance ToleranceKeepsThresholds ReportMemory
  ReportLocaleOfStreams ReportLocaleOfC ReportStrings)

vtk_module_test_executable(TestPassContract
  vtkIndirectContractKinds.cxx
  vtkIndirectContractMain.cxx
  vtkIndirectContractReport.cxx
  vtkIndirectContractScenes.cxx
  vtkIndirectContractUtilities.cxx
  ${contract_sources})
target_link_libraries(TestPassContract
  PRIVATE
    VTK::IndirectHeadless
    # The loader through which VTK calls OpenGL: one of the two, by VTK's version.
    $<TARGET_NAME_IF_EXISTS:VTK::glew>
    $<TARGET_NAME_IF_EXISTS:VTK::glad>
    $<TARGET_NAME_IF_EXISTS:OpenGL::OpenGL>)
vtk_indirect_compile_options(TestPassContract)

foreach (test IN LISTS contract_tests)
  add_test(NAME "Contract.${test}" COMMAND TestPassContract "${test}")
  set_tests_properties("Contract.${test}" PROPERTIES
    LABELS contract
    TIMEOUT 120
    SKIP_RETURN_CODE 125
    FAIL_REGULAR_EXPRESSION "ERR\\|;ERROR: ;instance(s)? still around"
    ENVIRONMENT "DISPLAY=;WAYLAND_DISPLAY=")
endforeach ()
# Mesa passes for an older OpenGL.
set_property(TEST Contract.PathsOpenGL32 Contract.ReportClocksOpenGL32 Contract.ReportClocksNone
  APPEND PROPERTY ENVIRONMENT "MESA_GL_VERSION_OVERRIDE=3.2")
set_property(TEST Contract.ReportClocksNone
  APPEND PROPERTY ENVIRONMENT "MESA_EXTENSION_OVERRIDE=-GL_ARB_timer_query")
add_test(NAME Contract.List COMMAND TestPassContract --check-list ${contract_tests})
set_tests_properties(Contract.List PROPERTIES LABELS contract)

# Pictures against baselines in Testing/Data/Baseline: composition as a whole. What the light is
# worth in numbers is for the other tests.
vtk_add_test_cxx(TestImages image_tests
  NO_DATA
  ImageComposition.cxx
  ImageDensity.cxx
  ImageNormal.cxx
  ImageRoom.cxx)
vtk_test_cxx_executable(TestImages image_tests RENDERING_FACTORY
  vtkIndirectContractScenes.cxx
  vtkIndirectImageUtilities.cxx)
target_link_libraries(TestImages PRIVATE VTK::IndirectHeadless)
vtk_indirect_compile_options(TestImages)
foreach (test IN LISTS image_tests)
  get_filename_component(test "${test}" NAME_WE)
  set_tests_properties("${_vtk_build_test}Cxx-${test}" PROPERTIES
    LABELS image
    ENVIRONMENT "DISPLAY=;WAYLAND_DISPLAY=")
endforeach ()
