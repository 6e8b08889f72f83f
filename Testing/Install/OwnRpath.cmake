# Run by the test Install.OwnRpath.
cmake_minimum_required(VERSION 3.18)

# CMAKE_INSTALL_RPATH is the first folder that all installed files search for libraries. VTK's
# module system may add a folder after it.
set(own "/own/place:$ORIGIN/beside")
set(list "/own/place;$ORIGIN/beside")
file(REMOVE_RECURSE "${WORK_DIR}")
execute_process(
  COMMAND "${CMAKE_COMMAND}" -S "${SOURCE_DIR}" -B "${WORK_DIR}" -G "${GENERATOR}"
    "-DCMAKE_C_COMPILER=${C_COMPILER}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
    "-DVTK_DIR=${VTK_DIR}" -DBUILD_TESTING=OFF "-DVTK_INDIRECT_WRAP_PYTHON=${WRAP_PYTHON}"
    "-DPython3_EXECUTABLE=${PYTHON}" "-DCMAKE_INSTALL_RPATH=${list}"
  RESULT_VARIABLE result
  OUTPUT_QUIET)
if (NOT result EQUAL 0)
  message(FATAL_ERROR "the project cannot be configured (${result})")
endif ()

file(GLOB_RECURSE scripts "${WORK_DIR}/cmake_install.cmake")
set(found 0)
foreach (script IN LISTS scripts)
  file(STRINGS "${script}" lines REGEX "NEW_RPATH ")
  foreach (line IN LISTS lines)
    math(EXPR found "${found} + 1")
    string(FIND "${line}" "\"${own}\"" alone)
    string(FIND "${line}" "\"${own}:" first)
    if (alone EQUAL -1 AND first EQUAL -1)
      message(SEND_ERROR "${script} sets another: ${line}")
    endif ()
  endforeach ()
endforeach ()
message(STATUS "${found} files get the paths that were asked for")
set(least 1)
if (WRAP_PYTHON)
  set(least 2)
endif ()
if (found LESS least)
  message(FATAL_ERROR "nothing is installed with paths to libraries")
endif ()
