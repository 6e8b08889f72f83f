# Embeds GLSL files as string constants and hashes them, so that every measurement can be traced to
# the shader text it was made with.

# vtk_indirect_embed_shaders(<sources-var> FILES <file>...)
# Adds one generated source to <sources-var>: the table of all files' text by their base names.
function (vtk_indirect_embed_shaders sources_var)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "FILES")
  set(entries)
  set(names)
  set(texts)
  foreach (file IN LISTS arg_FILES)
    get_filename_component(name "${file}" NAME_WE)
    get_filename_component(path "${file}" ABSOLUTE)
    file(READ "${path}" text)
    if (text MATCHES "[^\t\n -~]")
      message(FATAL_ERROR "${file}: shader files are plain ASCII")
    endif ()
    string(LENGTH "${text}" length)
    if (length GREATER 60000)
      message(FATAL_ERROR "${file}: longer than 60000 characters, split it")
    endif ()
    if ("${name}" IN_LIST names)
      message(FATAL_ERROR "${file}: a second shader file of that base name")
    endif ()
    list(APPEND names "${name}")
    string(APPEND texts "${text}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${path}")
    string(REPLACE "\\" "\\\\" text "${text}")
    string(REPLACE "\"" "\\\"" text "${text}")
    string(REPLACE "\n" "\\n\"\n    \"" text "${text}")
    string(APPEND entries "  { \"${name}.glsl\",\n    \"${text}\" },\n")
  endforeach ()
  string(MD5 hash "${texts}")
  set(source "${CMAKE_CURRENT_BINARY_DIR}/vtkIndirectShaderTable.cxx")
  file(CONFIGURE OUTPUT "${source}" CONTENT
"// Generated from the shader files; do not edit.
#include \"OpenGL/vtkIndirectShaderTable.h\"

const vtkIndirectShaderTableEntry vtkIndirectShaderTable[] = {
${entries}  { nullptr, nullptr },
};
const char* const vtkIndirectShaderTableHash = \"${hash}\";
" @ONLY)
  # The oracle finds the object by its name.
  set_source_files_properties("${source}" PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set("${sources_var}" ${${sources_var}} "${source}" PARENT_SCOPE)
endfunction ()
