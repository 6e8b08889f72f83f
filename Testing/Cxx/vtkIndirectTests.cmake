# Finds the tests of C++ sources by their macro, so that no list of them is kept by hand.
#
# vtk_indirect_add_tests(<program> PREFIX <prefix> LABEL <label> SOURCES <file>...
#   [ARGUMENT <folder>] [FAIL_ON <regular expression>...] [ENVIRONMENT <variable>=<value>...])
# Adds <prefix>.<name> for each VTK_INDIRECT_TEST(<name>) at the beginning of a line of the sources. The
# test runs in its own process. <prefix>.Found fails if the program's tests differ from these.
# ARGUMENT: each test gets a subfolder of its name.
function (vtk_indirect_add_tests program)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "PREFIX;LABEL;ARGUMENT"
    "SOURCES;FAIL_ON;ENVIRONMENT")
  set(names)
  foreach (source IN LISTS arg_SOURCES)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
    file(STRINGS "${source}" lines REGEX "^VTK_INDIRECT_TEST\\(")
    foreach (line IN LISTS lines)
      string(REGEX REPLACE "^VTK_INDIRECT_TEST\\(([A-Za-z0-9_]+)\\).*$" "\\1" name "${line}")
      list(APPEND names "${name}")
    endforeach ()
  endforeach ()
  foreach (name IN LISTS names)
    set(folder)
    if (arg_ARGUMENT)
      set(folder "${arg_ARGUMENT}/${name}")
    endif ()
    add_test(NAME "${arg_PREFIX}.${name}" COMMAND "${program}" "${name}" ${folder})
  endforeach ()
  add_test(NAME "${arg_PREFIX}.Found" COMMAND "${program}" --compare ${names})
  set(failures "ERR\\|" "instance(s)? still around" "Sanitizer: " ${arg_FAIL_ON})
  list(TRANSFORM names PREPEND "${arg_PREFIX}.")
  set_tests_properties(${names} "${arg_PREFIX}.Found" PROPERTIES
    LABELS "${arg_LABEL}"
    TIMEOUT "${VTK_INDIRECT_TEST_TIMEOUT}"
    SKIP_RETURN_CODE 125
    FAIL_REGULAR_EXPRESSION "${failures}"
    # No test may find a display.
    ENVIRONMENT "DISPLAY=;WAYLAND_DISPLAY=;${arg_ENVIRONMENT}")
endfunction ()
