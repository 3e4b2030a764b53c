# Builds a game that adds tread with add_subdirectory (tests/package/consumer) and the tests of the plugin, with the
# sanitizers of the preset `sanitize`. With -Og, and with calls of the checks in place of their code: more optimisation and
# checks in line take longer to compile than they save in the few tests that run.
#   cmake -DSOURCE=... -DBUILD=... -DCOMPILER=... -DLAUNCHER=... -P build.cmake
cmake_minimum_required(VERSION 3.25)
file(READ ${SOURCE}/CMakePresets.json presets)
string(JSON last LENGTH ${presets} configurePresets)
math(EXPR last "${last} - 1")
foreach(i RANGE ${last})
    string(JSON name GET ${presets} configurePresets ${i} name)
    if(name STREQUAL "sanitize")
        string(JSON flags GET ${presets} configurePresets ${i} cacheVariables CMAKE_CXX_FLAGS)
    endif()
endforeach()
foreach(command
        "${CMAKE_COMMAND};-S;${SOURCE}/tests/package/consumer;-B;${BUILD};-G;Ninja;-DTREAD_FROM=source;-DTREAD_SOURCE=${SOURCE};-DTREAD_LAB=ON;-DTREAD_TESTS=ON;-DTREAD_WERROR=ON;-DCMAKE_BUILD_TYPE=RelWithDebInfo;-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-Og --param asan-instrumentation-with-call-threshold=0;-DCMAKE_CXX_FLAGS=${flags};-DCMAKE_CXX_COMPILER=${COMPILER};-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}"
        "${CMAKE_COMMAND};--build;${BUILD};--target;consumer;tests_bullet")
    execute_process(COMMAND ${command} RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
    if(NOT status EQUAL 0)
        list(JOIN command " " words)
        message(FATAL_ERROR "${words}\nfailed (${status}):\n${text}")
    endif()
endforeach()
