# The log that the program writes is the one on record.
#   cmake -DPROGRAM=... -DROOT=... -DOUT=... -P program.cmake
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${PROGRAM} run ${ROOT}/vehicles/compact.yaml ${ROOT}/scenarios/double_lane_change.yaml -o ${OUT} --quiet
    RESULT_VARIABLE status)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "tread run failed: ${status}")
endif()
file(SHA256 ${OUT}/log.csv sum)
file(STRINGS ${ROOT}/tests/bits/whole.sha256 record REGEX "  compact/double_lane_change.csv$")
if(NOT record MATCHES "^${sum} ")
    message(FATAL_ERROR "The log has the SHA-256 ${sum}, but on record is ${record}")
endif()
