# Runs a program on stock, and on tread with the figures of stock.
#   cmake -DSTOCK=... -DTREAD=... -DFIGURES=... -P compare.cmake
execute_process(COMMAND ${STOCK} RESULT_VARIABLE status OUTPUT_FILE ${FIGURES})
if(NOT status EQUAL 0)
    message(FATAL_ERROR "the program on stock ends with ${status}")
endif()
execute_process(COMMAND ${TREAD} ${FIGURES} RESULT_VARIABLE status OUTPUT_VARIABLE text)
file(READ ${FIGURES} stock)
message("---- on stock\n${stock}---- on tread\n${text}")
if(NOT status EQUAL 0)
    message(FATAL_ERROR "the program on tread ends with ${status}")
endif()
