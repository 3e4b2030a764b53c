# Builds run_logs for 64-bit ARM.
#   cmake -DSOURCE=... -DBUILD=... -DCOMPILER=... -DLAUNCHER=... -P build.cmake
include(ProcessorCount)
ProcessorCount(cores)
foreach(command
        "${CMAKE_COMMAND};-S;${SOURCE};-B;${BUILD};-G;Ninja;-DCMAKE_SYSTEM_NAME=Linux;-DCMAKE_SYSTEM_PROCESSOR=aarch64;-DCMAKE_CXX_COMPILER=${COMPILER};-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}"
        "${CMAKE_COMMAND};--build;${BUILD};--parallel;${cores}")
    execute_process(COMMAND ${command} RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
    if(NOT status EQUAL 0)
        list(JOIN command " " words)
        message(FATAL_ERROR "${words}\nfailed (${status}):\n${text}")
    endif()
endforeach()
