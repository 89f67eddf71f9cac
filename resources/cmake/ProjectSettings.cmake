# What every target of the project shares: language level, warnings as errors, floating-point rules,
# and `echotrail_library`, the one way a folder becomes a target.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

find_program(CCACHE ccache)
if(CCACHE)
  # The cache has to be told that precompiled headers may be relied on.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
endif()

add_library(project_settings INTERFACE)
# -ffp-contract=off: the same source gives the same bits whether or not the machine has fused multiply-add.
# -Wno-maybe-uninitialized: GCC 12 sees it in moved std::optional<std::string> where there is none.
# -Wno-restrict, and in Release the other warnings of overrun copies: GCC 12 sees them in std::string, where there are
# none, once headers are precompiled and inlining goes far. `dev` keeps the others on.
# -fno-math-errno: without it the compiler does not vectorise sqrt.
target_compile_options(project_settings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Wold-style-cast
  -Wno-missing-field-initializers -Wno-maybe-uninitialized -Wno-restrict -Werror -ffp-contract=off -fno-math-errno
  $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
  $<$<CONFIG:Release>:-Wno-array-bounds -Wno-stringop-overread -Wno-stringop-overflow>)
target_include_directories(project_settings INTERFACE ${CMAKE_SOURCE_DIR})
# QT_NO_KEYWORDS: Qt's `emit`, `signals` and `slots` macros break other libraries' headers.
target_compile_definitions(project_settings INTERFACE QT_NO_KEYWORDS)

# echotrail_library(NAME SOURCES file… [LINKS target…]): a static library from the files of one folder.
# Its LINKS are the only other folders it may include from at link time; the arrows are drawn in README.md.
function(echotrail_library name)
  cmake_parse_arguments(PARSE_ARGV 1 lib "" "" "SOURCES;LINKS")
  add_library(${name} STATIC ${lib_SOURCES})
  target_link_libraries(${name} PUBLIC project_settings ${lib_LINKS})
  use_pch(${name})
endfunction()
