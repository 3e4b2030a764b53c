# Builds the tests of the plugin with sanitizers. With -Og: more optimisation takes longer to compile than it saves in the
# few tests that run.
#   cmake -DSOURCE=... -DBUILD=... -DLAUNCHER=... -P build.cmake
foreach(command "${CMAKE_COMMAND};--preset;sanitize;-S;${SOURCE};-B;${BUILD};-DTREAD_WERROR=ON;-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-Og;-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}"
        "${CMAKE_COMMAND};--build;${BUILD};--target;tests_bullet;tests_bullet_float")
    execute_process(COMMAND ${command} WORKING_DIRECTORY ${SOURCE} RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
    if(NOT status EQUAL 0)
        list(JOIN command " " words)
        message(FATAL_ERROR "${words}\nfailed (${status}):\n${text}")
    endif()
endforeach()
