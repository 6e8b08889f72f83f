# Decides which optional modules are built. A missing package switches its module off with a message
# that names the package; nothing else of the project depends on it.

function (vtk_indirect_optional_module module option package found)
  if (NOT ${option})
    message(STATUS "${module}: off (${option} is OFF)")
    set(vtk_indirect_rejected ${vtk_indirect_rejected} "${module}" PARENT_SCOPE)
  elseif (NOT found)
    message(STATUS "${module}: off, ${package} was not found")
    set(vtk_indirect_rejected ${vtk_indirect_rejected} "${module}" PARENT_SCOPE)
  else ()
    message(STATUS "${module}: on")
    set(vtk_indirect_requested ${vtk_indirect_requested} "${module}" PARENT_SCOPE)
  endif ()
endfunction ()

find_package(glm REQUIRED)
find_package(nlohmann_json 3.7 REQUIRED)
find_package(OpenGL QUIET COMPONENTS EGL)
if (OpenGL_EGL_FOUND)
  set(_egl_found TRUE)
else ()
  set(_egl_found FALSE)
endif ()
vtk_indirect_optional_module(VTK::IndirectHeadless VTK_INDIRECT_ENABLE_HEADLESS
  "EGL (Debian: libegl-dev)" "${_egl_found}")

find_package(OpenEXR CONFIG QUIET)
if (OpenEXR_FOUND)
  set(_exr_found TRUE)
else ()
  set(_exr_found FALSE)
endif ()
vtk_indirect_optional_module(VTK::IndirectOpenEXR VTK_INDIRECT_ENABLE_OPENEXR
  "OpenEXR (Debian: libopenexr-dev)" "${_exr_found}")

find_package(OpenMesh CONFIG QUIET)
if (OpenMesh_FOUND)
  set(_openmesh_found TRUE)
else ()
  set(_openmesh_found FALSE)
endif ()
vtk_indirect_optional_module(VTK::IndirectProxies VTK_INDIRECT_ENABLE_PROXIES
  "OpenMesh (Debian: libopenmesh-dev)" "${_openmesh_found}")
