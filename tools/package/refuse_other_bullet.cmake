# Lets the linker refuse a program that links `target` and Bullet in the other precision, by a linker script. GNU ld, gold
# and lld read it; a linker that does not is asked once and left without it. Then the library itself ends such a program
# at its start.
include_guard(GLOBAL)

function(tread_refuse_other_bullet target script)
    if(DEFINED TREAD_REFUSE_OTHER_BULLET AND NOT TREAD_REFUSE_OTHER_BULLET)
        return()
    endif()
    if(NOT DEFINED TREAD_LINKER_READS_SCRIPTS)
        include(CheckCXXSourceCompiles)
        set(CMAKE_TRY_COMPILE_TARGET_TYPE EXECUTABLE)
        set(CMAKE_REQUIRED_QUIET TRUE)
        get_directory_property(options LINK_OPTIONS)
        list(APPEND CMAKE_REQUIRED_LINK_OPTIONS ${options})
        list(APPEND CMAKE_REQUIRED_LIBRARIES "${script}")
        check_cxx_source_compiles("int main() {}" TREAD_LINKER_READS_SCRIPTS)
    endif()
    if(TREAD_LINKER_READS_SCRIPTS)
        target_link_libraries(${target} INTERFACE "$<BUILD_INTERFACE:${script}>")
    endif()
endfunction()
