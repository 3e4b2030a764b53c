# Checks that the port is one changed line and an include, and that both programs run and end where such a van stops.
#   cmake -DFOLDER=... -DBEFORE=... -DAFTER=... -P check.cmake
file(READ ${FOLDER}/before.cpp before)
file(READ ${FOLDER}/after.cpp after)
string(REPLACE "\n#include <tread/raycast_vehicle.h>" "" back "${after}")
string(REPLACE "vehicle = std::make_unique<tread::RaycastVehicle>(" "vehicle = std::make_unique<btRaycastVehicle>(" back "${back}")
if(before STREQUAL after OR NOT before STREQUAL back)
    message(SEND_ERROR "after.cpp differs from before.cpp by more than the include and the class that is made")
endif()

foreach(program ${BEFORE} ${AFTER})
    execute_process(COMMAND ${program} RESULT_VARIABLE status OUTPUT_VARIABLE text)
    message("${program}\n${text}")
    # 3000 N on each of two wheels and 1800 kg make 13.3 m/s in 4 s, less what rolling takes; then it brakes to a stop on its wheels.
    if(NOT status EQUAL 0 OR NOT text MATCHES " 4 s: +4[5-9]\\.[0-9] km/h" OR NOT text MATCHES "10 s: +-?0\\.0 km/h")
        message(SEND_ERROR "the van does not drive as it should (exit status ${status})")
    endif()
endforeach()
