# The report is one self-contained HTML file: the libraries that Debian packages (charts, replay) and our own styles and
# scripts become string constants in the library. Nothing third-party lives in this repository.
set(embedded_definitions "")
function(embed name file)
    file(READ ${file} content)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    set(embedded_definitions
        "${embedded_definitions}const std::string_view ${name} = R\"embedded_file(${content})embedded_file\"sv;\n" PARENT_SCOPE)
endfunction()

# embed_packaged(name variable package folder file): a file of a Debian package.
macro(embed_packaged name variable package folder file)
    find_file(${variable} ${file} PATHS /usr${folder} /usr/local${folder} NO_DEFAULT_PATH)
    if(NOT ${variable})
        message(FATAL_ERROR "The report needs ${file}, which was not found in /usr${folder}: install the Debian package "
            "${package} (apt-get install ${package}), or give the file with -D${variable}=/path/to/it, or build without the "
            "laboratory (-DTREAD_LAB=OFF).")
    endif()
    embed(${name} ${${variable}})
endmacro()

set(dygraphs libjs-dygraphs /share/javascript/dygraphs)
embed_packaged(kDygraphsScript DYGRAPHS_SCRIPT ${dygraphs} dygraph.min.js)
embed_packaged(kDygraphsStyle DYGRAPHS_STYLE ${dygraphs} dygraph.min.css)
embed_packaged(kDygraphsSynchronizer DYGRAPHS_SYNCHRONIZER ${dygraphs} src/extras/synchronizer.js)
embed_packaged(kDygraphsLicence DYGRAPHS_LICENCE libjs-dygraphs /share/doc/libjs-dygraphs copyright)
# The classic builds: a page that is opened as a file cannot import modules.
set(three libjs-three /share/javascript/three)
embed_packaged(kThreeScript THREE_SCRIPT ${three} three.min.js)
embed_packaged(kThreeOrbit THREE_ORBIT ${three} examples/js/controls/OrbitControls.js)
embed_packaged(kThreeLicence THREE_LICENCE libjs-three /share/doc/libjs-three copyright)
embed(kPageStyle ${CMAKE_CURRENT_LIST_DIR}/page.css)
embed(kValuesScript ${CMAKE_CURRENT_LIST_DIR}/values.js)
embed(kChartsScript ${CMAKE_CURRENT_LIST_DIR}/charts.js)
embed(kReplayStyle ${CMAKE_CURRENT_LIST_DIR}/replay.css)
embed(kReplayCarScript ${CMAKE_CURRENT_LIST_DIR}/replay_car.js)
embed(kReplayRoadScript ${CMAKE_CURRENT_LIST_DIR}/replay_road.js)
embed(kReplayScript ${CMAKE_CURRENT_LIST_DIR}/replay.js)

file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/report/embedded.cpp @ONLY CONTENT
"// Generated from the files named in src/report/embed.cmake.
#include \"report/embedded.h\"

#pragma GCC diagnostic ignored \"-Woverlength-strings\"  // longer than the standard promises, not than compilers take

using namespace std::string_view_literals;

namespace tread::embedded {
@embedded_definitions@
}
")
target_sources(tread_lab PRIVATE ${CMAKE_BINARY_DIR}/report/embedded.cpp)
