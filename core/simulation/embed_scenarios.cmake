# Writes a C++ file that holds the text of FILES for echotrail::scenarioTexts(). A string literal of a compiler may be
# limited to 16 KB; a scenario is far below that.
set(entries "")
foreach(file IN LISTS FILES)
  file(READ ${file} text)
  get_filename_component(name ${file} NAME)
  string(APPEND entries "        {\"${name}\", R\"scenario(${text})scenario\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Made by embed_scenarios.cmake from resources/scenarios.
#include \"core/simulation/scenario_file.hpp\"

namespace echotrail {

const std::vector<ScenarioText>& scenarioTexts() {
    static const std::vector<ScenarioText> all{
${entries}    };
    return all;
}

}  // namespace echotrail
")
