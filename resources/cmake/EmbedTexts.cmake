# embed_texts(OUTPUT FILES… HEADER header TYPE type FUNCTION function COMPONENT component): sets OUTPUT to a C++ file, made
# when built, that defines `const std::vector<type>& function()` with {name, text} of each file; `component` (NAME or
# NAME_WE) says whether a name keeps its ending. With ROOT folder instead of COMPONENT, a name is the path from there
# without its ending. So the programs need no file beside them.
# Run as a script it writes that file. A string literal may be limited to 16 KB; these texts are far below.
if(CMAKE_SCRIPT_MODE_FILE)
  set(entries "")
  foreach(file IN LISTS FILES)
    file(READ ${file} text)
    if(ROOT)
      file(RELATIVE_PATH name ${ROOT} ${file})
      string(REGEX REPLACE "\\.[^.]*$" "" name ${name})
    else()
      get_filename_component(name ${file} ${COMPONENT})
    endif()
    string(APPEND entries "        {\"${name}\", R\"embedded(${text})embedded\"},\n")
  endforeach()
  file(WRITE ${OUTPUT} "// Made by EmbedTexts.cmake.
#include \"${HEADER}\"

namespace echotrail {

const std::vector<${TYPE}>& ${FUNCTION}() {
    static const std::vector<${TYPE}> all{
${entries}    };
    return all;
}

}  // namespace echotrail
")
  return()
endif()

set(embed_texts_script ${CMAKE_CURRENT_LIST_FILE})

function(embed_texts output)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "HEADER;TYPE;FUNCTION;COMPONENT;ROOT" "FILES")
  set(made ${CMAKE_CURRENT_BINARY_DIR}/${arg_FUNCTION}.cpp)
  add_custom_command(
    OUTPUT ${made}
    COMMAND ${CMAKE_COMMAND} "-DFILES=${arg_FILES}" -DOUTPUT=${made} -DHEADER=${arg_HEADER} -DTYPE=${arg_TYPE}
            -DFUNCTION=${arg_FUNCTION} -DCOMPONENT=${arg_COMPONENT} -DROOT=${arg_ROOT} -P ${embed_texts_script}
    DEPENDS ${arg_FILES} ${embed_texts_script}
    COMMENT "Embedding ${arg_FUNCTION}" VERBATIM)
  set(${output} ${made} PARENT_SCOPE)
endfunction()
