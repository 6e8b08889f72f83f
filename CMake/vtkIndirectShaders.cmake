# Embeds GLSL files as string constants and hashes them, so that every measurement can be traced to
# the shader text it was made with.

# vtk_indirect_embed_shaders(<sources-var> FILES <file>...)
# Adds generated sources to <sources-var>; the registry lists every file by its base name.
function (vtk_indirect_embed_shaders sources_var)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "FILES")
  set(sources)
  set(includes)
  set(entries)
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
    vtk_encode_string(INPUT "${path}" NAME "${name}"
      HEADER_OUTPUT header SOURCE_OUTPUT source)
    list(APPEND sources "${source}" "${header}")
    string(APPEND includes "#include \"${name}.h\"\n")
    string(APPEND entries "  { \"${name}.glsl\", ${name} },\n")
  endforeach ()
  string(MD5 hash "${texts}")
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/vtkIndirectShaderTable.cxx" CONTENT
"// Generated from the shader files; do not edit.
#include \"OpenGL/vtkIndirectShaderTable.h\"

${includes}
const vtkIndirectShaderTableEntry vtkIndirectShaderTable[] = {
${entries}  { nullptr, nullptr },
};
const char* const vtkIndirectShaderTableHash = \"${hash}\";
" @ONLY)
  list(APPEND sources "${CMAKE_CURRENT_BINARY_DIR}/vtkIndirectShaderTable.cxx")
  set("${sources_var}" ${${sources_var}} ${sources} PARENT_SCOPE)
endfunction ()
