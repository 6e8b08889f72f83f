# Chooses the Python interpreter that sees VTK's own Python package. Another python3 may come first
# on PATH (pyenv, conda) and know nothing of the VTK that is being built against.
if (NOT VTK_INDIRECT_WRAP_PYTHON OR Python3_EXECUTABLE)
  return ()
endif ()

set(_candidates)
find_program(_path_python python3)
mark_as_advanced(_path_python)
foreach (_candidate IN ITEMS "${_path_python}" /usr/bin/python3 /usr/local/bin/python3)
  if (NOT EXISTS "${_candidate}")
    continue ()
  endif ()
  execute_process(COMMAND "${_candidate}" -c "import vtkmodules.vtkCommonCore"
    RESULT_VARIABLE _failed OUTPUT_QUIET ERROR_QUIET)
  if (NOT _failed)
    set(Python3_EXECUTABLE "${_candidate}" CACHE FILEPATH "Interpreter that can import vtkmodules")
    break ()
  endif ()
endforeach ()

if (NOT Python3_EXECUTABLE)
  message(FATAL_ERROR
    "No python3 can import vtkmodules (tried PATH and /usr/bin). Install VTK's Python package "
    "(Debian: python3-vtk9), set Python3_EXECUTABLE, or configure with "
    "-DVTK_INDIRECT_WRAP_PYTHON=OFF.")
endif ()
