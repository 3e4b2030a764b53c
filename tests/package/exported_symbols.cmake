# Links the objects of tread and tread_float to shared libraries and compares what these export with exported_symbols.txt,
# one list for both: Bullet's namespace and numbers are written as those of double precision.
#   cmake -DFOLDER=... -DCOMPILER=... -DNM=... -DEXPORTS=... -DBUILD=... [-DUPDATE=ON] -P exported_symbols.cmake
set(list_file ${CMAKE_CURRENT_LIST_DIR}/exported_symbols.txt)

# Names that a library exports, sorted.
function(exported_symbols library result)
    set(file ${FOLDER}/exports_of_${library}.so)
    execute_process(COMMAND ${COMPILER} -shared -o ${file} -Wl,--version-script=${EXPORTS} @${FOLDER}/${library}_objects.txt
        COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${NM} -D --defined-only -C ${file} OUTPUT_VARIABLE names COMMAND_ERROR_IS_FATAL ANY)
    file(REMOVE ${file})
    string(REGEX REPLACE "(^|\n)[0-9a-f]+ [A-Za-z] " "\\1" names "${names}")
    string(REPLACE bullet_float32 bullet_float64 names "${names}")
    string(REGEX REPLACE "([(, ])float([,)])" "\\1double\\2" names "${names}")
    string(STRIP "${names}" names)
    string(REPLACE "\n" ";" names "${names}")
    list(SORT names)
    list(REMOVE_DUPLICATES names)
    set(${result} "${names}" PARENT_SCOPE)
endfunction()

if(UPDATE)
    exported_symbols(tread names)
    list(JOIN names "\n" text)
    file(WRITE ${list_file} "${text}\n")
    list(LENGTH names count)
    message("${list_file}: ${count} names")
    return()
endif()

file(STRINGS ${list_file} listed)
foreach(library tread tread_float)
    exported_symbols(${library} names)
    set(came ${names})
    list(REMOVE_ITEM came ${listed})
    set(went ${listed})
    list(REMOVE_ITEM went ${names})
    if(came OR went)
        list(TRANSFORM came PREPEND "\n  + ")
        list(TRANSFORM went PREPEND "\n  - ")
        list(APPEND came ${went})
        string(CONCAT difference ${came})
        message(SEND_ERROR "${library} exports other names than ${list_file}:${difference}\n"
            "If that is meant: cmake --build ${BUILD} --target update_exported_symbols")
    endif()
endforeach()
