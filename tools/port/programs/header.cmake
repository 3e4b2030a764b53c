# What a compiler says of tread/raycast_vehicle.h.
#   update_friction, ray_cast, update_suspension: a class that overrides what would do nothing does not compile, and the
#       compiler shows the header's line that says what to do instead
#   plain: as C++17 without exceptions and run-time type information there are no warnings
#   files: it needs nothing but Bullet, the standard library as far as Bullet does, and three files of tread
#   cmake -DCHECK=... -DFOLDER=... -DCOMPILER=... -DTREAD_FOLDERS=... -DBULLET_FOLDERS=... -DBULLET_FLAGS=... -P header.cmake
set(flags -std=c++17 ${BULLET_FLAGS})
foreach(folder IN LISTS TREAD_FOLDERS)
    list(APPEND flags -I${folder})
endforeach()
foreach(folder IN LISTS BULLET_FOLDERS)
    list(APPEND flags -isystem ${folder})
endforeach()

# Compiles `source`: `status`, `text` gets the compiler's words, in English whatever the user's language is, `output` what
# it puts out.
set(ENV{LC_ALL} C)
function(compile source)
    set(file ${FOLDER}/header_${CHECK}.cpp)
    file(WRITE ${file} "${source}")
    execute_process(COMMAND ${COMPILER} ${flags} ${ARGN} ${file}
        RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE text)
    set(status ${status} PARENT_SCOPE)
    set(text "${text}" PARENT_SCOPE)
    set(output "${output}" PARENT_SCOPE)
endfunction()

# A subclass with `member` must not compile, and the compiler must show `advice`. On stock it must: else it proves nothing.
function(refused member advice)
    foreach(base btRaycastVehicle tread::RaycastVehicle)
        compile("#include <tread/raycast_vehicle.h>
            struct Car : ${base} {
                Car(btRigidBody* body) : ${base}(btVehicleTuning(), body, nullptr) {}
                ${member}
            };" -fsyntax-only)
        if(base STREQUAL btRaycastVehicle AND NOT status EQUAL 0)
            message(FATAL_ERROR "'${member}' does not even compile on stock:\n${text}")
        endif()
    endforeach()
    string(FIND "${text}" "${advice}" at)
    if(status EQUAL 0 OR at EQUAL -1)
        message(FATAL_ERROR "'${member}' must not compile, and the compiler must show '${advice}'; status ${status}:\n${text}")
    endif()
endfunction()

if(CHECK STREQUAL update_friction)
    refused("void updateFriction(btScalar) override {}" "friction is the tyres': override updateVehicle, or see setGrip")
elseif(CHECK STREQUAL ray_cast)
    refused("btScalar rayCast(btWheelInfo&) { return -1; }" "give the constructor a btVehicleRaycaster of your own instead")
elseif(CHECK STREQUAL update_suspension)
    refused("void updateSuspension(btScalar) {}" "set stiffness, damping and force of the wheel infos instead")
elseif(CHECK STREQUAL plain)
    compile("#include <tread/raycast_vehicle.h>\nint main() {}\n" -fno-exceptions -fno-rtti -Wall -Wextra -pedantic
        -Werror -fsyntax-only)
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "${text}")
    endif()
elseif(CHECK STREQUAL files)
    # The files that a source needs, without the source itself.
    function(files_of source result)
        compile("${source}" -M)
        if(NOT status EQUAL 0)
            message(FATAL_ERROR "${text}")
        endif()
        string(REGEX REPLACE "^[^:]*:" "" output "${output}")
        string(REPLACE "\\\n" " " output "${output}")
        separate_arguments(files UNIX_COMMAND "${output}")
        list(FILTER files EXCLUDE REGEX "/header_files\\.cpp$")
        set(${result} ${files} PARENT_SCOPE)
    endfunction()
    files_of("#include <BulletDynamics/Vehicle/btRaycastVehicle.h>\n" bullets)
    files_of("#include <tread/raycast_vehicle.h>\n" treads)
    list(REMOVE_ITEM treads ${bullets})
    list(FILTER treads EXCLUDE REGEX "/tread/(raycast_vehicle|api|bullet_precision)\\.h$")
    if(treads OR NOT bullets)
        message(FATAL_ERROR "tread/raycast_vehicle.h also needs ${treads}")
    endif()
else()
    message(FATAL_ERROR "no such check: '${CHECK}'")
endif()
