# Run by the test Install.Consume.
cmake_minimum_required(VERSION 3.18)

# run(<what> <command>...): stops the test when the command fails.
function (run what)
  message(STATUS "${what}")
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    message(FATAL_ERROR "failed (${result}): ${what}")
  endif ()
endfunction ()

function (require_file path)
  if (NOT EXISTS "${path}")
    message(FATAL_ERROR "${path} is missing")
  endif ()
endfunction ()

file(REMOVE_RECURSE "${WORK_DIR}")
file(MAKE_DIRECTORY "${WORK_DIR}")

# Installs into a path with a space and moves the result: no file may depend on the first path.
run("install" "${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${WORK_DIR}/first place")
set(prefix "${WORK_DIR}/second place")
file(RENAME "${WORK_DIR}/first place" "${prefix}")

# Installed text files do not mention the source or build tree.
file(GLOB_RECURSE texts "${prefix}/*.cmake" "${prefix}/*.py" "${prefix}/*.h" "${prefix}/bin/*")
foreach (text IN LISTS texts)
  file(STRINGS "${text}" lines)
  foreach (folder IN ITEMS "${BUILD_DIR}" "${SOURCE_DIR}")
    string(FIND "${lines}" "${folder}/" position)
    if (NOT position EQUAL -1)
      message(FATAL_ERROR "${text} mentions ${folder}")
    endif ()
  endforeach ()
endforeach ()

# The tests' oracle is not a part of the product.
file(GLOB_RECURSE oracle "${prefix}/*Oracle*" "${prefix}/*Reference*")
if (oracle)
  message(FATAL_ERROR "${oracle} is installed")
endif ()

run("configure the examples" "${CMAKE_COMMAND}"
  -S "${SOURCE_DIR}/Examples/Cxx" -B "${WORK_DIR}/examples" -G "${GENERATOR}" -Werror=dev
  "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}"
  "-DCMAKE_C_COMPILER=${C_COMPILER}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
  "-DVTK_DIR=${VTK_DIR}" "-DCMAKE_PREFIX_PATH=${prefix}")
run("build the examples" "${CMAKE_COMMAND}" --build "${WORK_DIR}/examples")

# A version that is not installed, and a component that does not exist, are refused.
file(WRITE "${WORK_DIR}/refused/CMakeLists.txt" "
cmake_minimum_required(VERSION 3.18)
project(refused LANGUAGES C CXX)
find_package(vtkIndirect 99 QUIET)
if (vtkIndirect_FOUND)
  message(FATAL_ERROR \"version 99 was found\")
endif ()
find_package(vtkIndirect ${VERSION} QUIET COMPONENTS NoSuchModule)
if (vtkIndirect_FOUND)
  message(FATAL_ERROR \"a component that does not exist was found\")
endif ()
find_package(vtkIndirect ${VERSION} REQUIRED)
if (NOT vtkIndirect_LIBRARIES MATCHES \"VTK::RenderingIndirect\")
  message(FATAL_ERROR \"vtkIndirect_LIBRARIES is \${vtkIndirect_LIBRARIES}\")
endif ()
")
run("look for what is not there" "${CMAKE_COMMAND}"
  -S "${WORK_DIR}/refused" -B "${WORK_DIR}/refused/build" -G "${GENERATOR}"
  "-DCMAKE_C_COMPILER=${C_COMPILER}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DVTK_DIR=${VTK_DIR}" "-DCMAKE_PREFIX_PATH=${prefix}")

if (PYTHON)
  foreach (file IN ITEMS py.typed __init__.pyi vtkRenderingIndirect.pyi)
    require_file("${prefix}/${PYTHON_PATH}/vtkindirect/${file}")
  endforeach ()
  run("import the Python package" "${CMAKE_COMMAND}" -E env
    "PYTHONPATH=${prefix}/${PYTHON_PATH}" "${PYTHON}" -c "
import os, vtkindirect
from vtkindirect.vtkRenderingIndirect import vtkIndirectIlluminationPass
assert os.path.samefile(os.path.dirname(vtkindirect.__path__[0]), r'${prefix}/${PYTHON_PATH}')
print(vtkIndirectIlluminationPass().GetClassName())
scene = vtkindirect.load_scene(r'${prefix}/share/vtkindirect/Scenes/protein.json')
try:
    vtkindirect.enable(scene.renderer, 'reference')
    raise SystemExit('the oracle is there')
except vtkindirect.UsageError as error:
    assert 'built with them and not installed' in str(error), error
")
  if (EXISTS "${BUILD_DIR}/bin/vtk-indirect")
    require_file("${prefix}/bin/vtk-indirect")
    run("run the command" "${prefix}/bin/vtk-indirect" --help)
  endif ()
endif ()

# Last, because it needs a driver.
set(result 125)
if (HEADLESS_TEST)
  execute_process(COMMAND "${HEADLESS_TEST}" Render RESULT_VARIABLE result)
endif ()
if (result EQUAL 125)
  message("SKIPPED: the example cannot run here without a display")
  return ()
endif ()
run("run the example" "${WORK_DIR}/examples/IndirectIllumination" "${WORK_DIR}/picture.png")
file(SIZE "${WORK_DIR}/picture.png" size)
if (size LESS 5000)
  message(FATAL_ERROR "the picture has only ${size} bytes")
endif ()
