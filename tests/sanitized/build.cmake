# Builds the tests of the plugin with sanitizers. With -Og, and with calls of the checks in place of their code: more
# optimisation and checks in line take longer to compile than they save in the few tests that run.
#   cmake -DSOURCE=... -DBUILD=... -DLAUNCHER=... -P build.cmake
foreach(command "${CMAKE_COMMAND};--preset;sanitize;-S;${SOURCE};-B;${BUILD};-DTREAD_WERROR=ON;-DCMAKE_CXX_FLAGS_RELWITHDEBINFO=-Og --param asan-instrumentation-with-call-threshold=0;-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}"
        "${CMAKE_COMMAND};--build;${BUILD};--target;tests_bullet;tests_bullet_float")
    execute_process(COMMAND ${command} WORKING_DIRECTORY ${SOURCE} RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
    if(NOT status EQUAL 0)
        list(JOIN command " " words)
        message(FATAL_ERROR "${words}\nfailed (${status}):\n${text}")
    endif()
endforeach()
