# Drives all shipped scenarios and compares the SHA-256 of each log with the one on record: the same bytes on every
# machine.
#   cmake -DEMULATOR=... -DPROGRAM=... -DROOT=... -DPART=whole|begin -DOUT=... [-DUPDATE=ON] -P bits.cmake
# With UPDATE the record is renewed.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${OUT})
file(MAKE_DIRECTORY ${OUT})
execute_process(COMMAND ${EMULATOR} ${PROGRAM} ${ROOT} ${OUT} ${PART} RESULT_VARIABLE status)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "run_logs failed: ${status}")
endif()

# In the format of sha256sum.
set(record ${ROOT}/tests/bits/${PART}.sha256)
file(GLOB_RECURSE logs RELATIVE ${OUT} ${OUT}/*.csv)
list(SORT logs)
set(found "")
foreach(log ${logs})
    file(SHA256 ${OUT}/${log} sum)
    list(APPEND found "${sum}  ${log}")
endforeach()
if(UPDATE)
    list(JOIN found "\n" text)
    file(WRITE ${record} "${text}\n")
    return()
endif()

file(STRINGS ${record} expected)
set(other "")
foreach(line ${found} ${expected})
    if(NOT line IN_LIST found OR NOT line IN_LIST expected)
        string(REGEX REPLACE "^[0-9a-f]+  " "" name "${line}")
        list(APPEND other ${name})
    endif()
endforeach()
list(REMOVE_DUPLICATES other)
if(other)
    list(JOIN other ", " names)
    message(FATAL_ERROR "These logs have other bytes than on record, or are new, or are gone: ${names}. If the change is "
        "meant, `tools/update_golden` renews ${record}.")
endif()
