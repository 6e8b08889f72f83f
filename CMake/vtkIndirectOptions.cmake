# Options of the build and the defaults that VTK's module system needs.

option(BUILD_SHARED_LIBS "Build shared libraries (Python wrapping needs them)" ON)
option(BUILD_TESTING "Build the tests" ON)
option(VTK_INDIRECT_WRAP_PYTHON "Wrap the modules for Python" ON)
option(VTK_INDIRECT_ENABLE_HEADLESS "Build VTK::IndirectHeadless (needs EGL)" ON)
option(VTK_INDIRECT_ENABLE_OPENEXR "Build VTK::IndirectOpenEXR (needs OpenEXR)" ON)
option(VTK_INDIRECT_ENABLE_PROXIES "Build VTK::IndirectProxies (needs OpenMesh)" ON)
option(VTK_INDIRECT_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" OFF)
set(VTK_INDIRECT_SANITIZE "" CACHE STRING "Sanitizers to build with, e.g. address,undefined")

# Repeated builds are faster with ccache.
if (NOT CMAKE_CXX_COMPILER_LAUNCHER)
  find_program(VTK_INDIRECT_CCACHE ccache DOC "Compiler cache, used if found")
  mark_as_advanced(VTK_INDIRECT_CCACHE)
  if (VTK_INDIRECT_CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER "${VTK_INDIRECT_CCACHE}")
  endif ()
endif ()

if (NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif ()

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")

# An installed tree can be moved: libraries and programs look for each other relative to themselves,
# unless CMAKE_INSTALL_RPATH says otherwise.
set(vtk_indirect_relative_rpath TRUE)
if (DEFINED CMAKE_INSTALL_RPATH)
  set(vtk_indirect_relative_rpath FALSE)
else ()
  file(RELATIVE_PATH _bin_to_lib "/${CMAKE_INSTALL_BINDIR}" "/${CMAKE_INSTALL_LIBDIR}")
  set(CMAKE_INSTALL_RPATH "$ORIGIN;$ORIGIN/${_bin_to_lib}")
endif ()

if (BUILD_TESTING)
  set(VTK_INDIRECT_TESTS_WANTED WANT)
  # Only a test that hangs may end by the clock, however busy the machine is.
  set(VTK_INDIRECT_TEST_TIMEOUT 1500 CACHE STRING
    "Seconds after which a test counts as one that would never end")
  mark_as_advanced(VTK_INDIRECT_TEST_TIMEOUT)
  enable_testing()
else ()
  set(VTK_INDIRECT_TESTS_WANTED OFF)
endif ()

# Applies our warnings to a target of ours; wrapped sources are VTK's to worry about. The headers of
# VTK cost more than most sources: with CMAKE_UNITY_BUILD a folder's sources are one unit.
function (vtk_indirect_compile_options target)
  get_target_property(sources "${target}" SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cxx$")
  foreach (source IN LISTS sources)
    get_filename_component(folder "${source}" ABSOLUTE)
    get_filename_component(folder "${folder}" DIRECTORY)
    file(RELATIVE_PATH folder "${CMAKE_SOURCE_DIR}" "${folder}")
    string(MAKE_C_IDENTIFIER "${folder}" folder)
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${folder}")
  endforeach ()
  set_target_properties("${target}" PROPERTIES UNITY_BUILD_MODE GROUP)
  target_compile_options("${target}" PRIVATE
    "$<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang>:-Wall;-Wextra;-Wshadow;-Wno-unused-parameter>")
  if (VTK_INDIRECT_WARNINGS_AS_ERRORS)
    target_compile_options("${target}" PRIVATE
      "$<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang>:-Werror>")
  endif ()
endfunction ()

if (VTK_INDIRECT_SANITIZE)
  add_compile_options("-fsanitize=${VTK_INDIRECT_SANITIZE}" -fno-omit-frame-pointer)
  add_link_options("-fsanitize=${VTK_INDIRECT_SANITIZE}")
endif ()
