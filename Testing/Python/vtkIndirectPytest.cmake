# vtk_indirect_add_pytest(NAME FILE LABEL [VARIABLE=VALUE...]): a test that is a file for
# pytest, which may import the package. It is skipped when all in it is (see conftest.py), and where
# there is no pytest; the output says why.
function (vtk_indirect_add_pytest name file label)
  add_test(NAME "${name}" COMMAND "${Python3_EXECUTABLE}" -B -m pytest "${file}")
  set_tests_properties("${name}" PROPERTIES
    LABELS "${label}"
    SKIP_RETURN_CODE 125
    SKIP_REGULAR_EXPRESSION "No module named '?pytest"
    TIMEOUT "${VTK_INDIRECT_TEST_TIMEOUT}"
    ENVIRONMENT "PYTHONPATH=${CMAKE_BINARY_DIR}/${vtk_indirect_python_dir};${ARGN}")
endfunction ()
