# What is compiled for processors with AVX2 or AVX-512 keeps to itself: a function that other files have as well, and
# that the linker may take from any of them, would stop the program on other processors. Such functions bear the
# namespace of their instruction set, or are inlined.
#   cmake -DOBJECTS=... -DNM=... -P instruction_sets.cmake
file(STRINGS ${OBJECTS} objects)
if(NOT objects)
    message(SEND_ERROR "${OBJECTS}: found no object, expected those with AVX2 and AVX-512")
endif()
foreach(object ${objects})
    execute_process(COMMAND ${NM} -C --defined-only ${object} OUTPUT_VARIABLE names COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCHALL "[0-9a-f]+ [WVu] [^\n]*" shared "${names}")
    list(FILTER shared EXCLUDE REGEX "tread::avx(2|512)::")
    if(shared)
        list(JOIN shared "\n  " text)
        message(SEND_ERROR "${object} defines what the linker may take for other processors:\n  ${text}")
    endif()
endforeach()
