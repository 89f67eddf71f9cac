# Writes a C++ file that holds the text of FILES for echotrail::presets(). A string literal of a compiler may be limited
# to 16 KB; a preset is far below that.
set(entries "")
foreach(file IN LISTS FILES)
  file(READ ${file} text)
  get_filename_component(name ${file} NAME_WE)
  string(APPEND entries "        {\"${name}\", R\"preset(${text})preset\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made by embed_presets.cmake from resources/presets.
#include \"core/pipelines/presets.hpp\"

namespace echotrail {

const std::vector<Preset>& presets() {
    static const std::vector<Preset> all{
${entries}    };
    return all;
}

}  // namespace echotrail
")
