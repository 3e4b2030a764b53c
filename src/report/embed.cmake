# The report is one self-contained HTML file: the chart library that Debian packages and our own style and script become
# string constants in the library. Nothing third-party lives in this repository.
set(dygraphs_folders /usr/share/javascript/dygraphs /usr/local/share/javascript/dygraphs)
find_file(DYGRAPHS_SCRIPT dygraph.min.js PATHS ${dygraphs_folders} NO_DEFAULT_PATH)
find_file(DYGRAPHS_STYLE dygraph.min.css PATHS ${dygraphs_folders} NO_DEFAULT_PATH)
find_file(DYGRAPHS_SYNCHRONIZER src/extras/synchronizer.js PATHS ${dygraphs_folders} NO_DEFAULT_PATH)
find_file(DYGRAPHS_LICENCE copyright PATHS /usr/share/doc/libjs-dygraphs NO_DEFAULT_PATH)
foreach(file DYGRAPHS_SCRIPT DYGRAPHS_STYLE DYGRAPHS_SYNCHRONIZER DYGRAPHS_LICENCE)
    if(NOT ${file})
        message(FATAL_ERROR "The charts of the report need dygraphs, and ${file} was not found in ${dygraphs_folders}: "
            "install the Debian package libjs-dygraphs (apt-get install libjs-dygraphs), or give the file with "
            "-D${file}=/path/to/it, or build without the laboratory (-DTREAD_LAB=OFF).")
    endif()
endforeach()

set(embedded_files
    kDygraphsScript ${DYGRAPHS_SCRIPT}
    kDygraphsStyle ${DYGRAPHS_STYLE}
    kDygraphsSynchronizer ${DYGRAPHS_SYNCHRONIZER}
    kDygraphsLicence ${DYGRAPHS_LICENCE}
    kPageStyle ${CMAKE_CURRENT_LIST_DIR}/page.css
    kPageScript ${CMAKE_CURRENT_LIST_DIR}/page.js)
set(embedded_definitions "")
while(embedded_files)
    list(POP_FRONT embedded_files name file)
    file(READ ${file} content)
    string(APPEND embedded_definitions
        "const std::string_view ${name} = R\"embedded_file(${content})embedded_file\"sv;\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
endwhile()
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
