# Installs the build into a prefix of its own (STEP=install), or builds and runs the consumer against it in one of the ways
# of consumer/CMakeLists.txt (STEP=package, source, pkgconfig, wrong_bullet and those in single precision).
#   cmake -DSTEP=... -DFOLDER=... -DBUILD=... -DSOURCE=... -DCOMPILER=... -DFLAGS=... -DLAUNCHER=... -P check.cmake
set(prefix "${FOLDER}/installed tread")

# Runs a command: `status` gets its exit status, `text` all that it printed.
function(run)
    execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
    set(status ${status} PARENT_SCOPE)
    set(text "${text}" PARENT_SCOPE)
endfunction()
function(must_run)
    run(${ARGV})
    if(NOT status EQUAL 0)
        list(JOIN ARGV " " command)
        message(FATAL_ERROR "${command}\nfailed (${status}):\n${text}")
    endif()
    set(text "${text}" PARENT_SCOPE)
endfunction()

# ---- Install, then move the result: an installed tree must not know where it was installed ----
if(STEP STREQUAL install)
    file(REMOVE_RECURSE ${FOLDER})
    set(first "${FOLDER}/first place")
    must_run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${first})
    foreach(file bin/tread include/tread/bullet_vehicle.h include/tread/load.h share/tread/vehicles/compact.yaml
            share/tread/vehicles/tyres share/tread/scenarios share/doc/tread/LICENSE)
        if(NOT EXISTS "${first}/${file}")
            message(SEND_ERROR "not installed: ${file}")
        endif()
    endforeach()

    # Nothing of this machine, and none of our own warnings and flags, may reach those who use the package.
    file(GLOB_RECURSE package_files "${first}/*.cmake" "${first}/*.pc")
    list(LENGTH package_files count)
    if(count LESS 5)
        message(SEND_ERROR "expected the CMake and pkg-config packages, found only: ${package_files}")
    endif()
    foreach(file ${package_files})
        file(READ "${file}" content)
        foreach(leak ${first} ${BUILD} ${SOURCE} -Werror -Wall -ffp-contract -fsanitize -O3 tread_options /usr/include
                /usr/lib)
            string(FIND "${content}" "${leak}" at)
            if(NOT at EQUAL -1)
                message(SEND_ERROR "${file} holds '${leak}'")
            endif()
        endforeach()
    endforeach()

    must_run("${first}/bin/tread" --version)
    file(RENAME ${first} ${prefix})
    return()
endif()

# ---- Configure, build and run the consumer ----
set(place ${FOLDER}/${STEP})
file(REMOVE_RECURSE ${place})
file(COPY ${CMAKE_CURRENT_LIST_DIR}/consumer DESTINATION ${place})
file(GLOB_RECURSE pc_file "${prefix}/tread.pc")
cmake_path(GET pc_file PARENT_PATH pc_folder)
set(ENV{PKG_CONFIG_PATH} ${pc_folder})
must_run(${CMAKE_COMMAND} -S ${place}/consumer -B ${place}/build -G Ninja -DTREAD_FROM=${STEP} -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_PREFIX_PATH=${prefix} -DTREAD_PREFIX=${prefix} -DTREAD_SOURCE=${SOURCE}
    -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_CXX_FLAGS=${FLAGS} -DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER})
run(${CMAKE_COMMAND} --build ${place}/build)
if(STEP MATCHES "^wrong_bullet")
    set(wrong bullet_float32)
    if(STEP STREQUAL wrong_bullet_float)
        set(wrong bullet_float64)
    endif()
    if(status EQUAL 0 OR NOT text MATCHES "undefined reference to [^\n]*${wrong}[^\n]*BulletVehicle")
        message(FATAL_ERROR "a program built for Bullet in the other precision must not link, and the linker must name "
            "${wrong}; status ${status}:\n${text}")
    endif()
    return()
endif()
if(NOT status EQUAL 0)
    message(FATAL_ERROR "the consumer does not build:\n${text}")
endif()
must_run(${place}/build/consumer "${prefix}/share/tread/vehicles/compact.yaml")
message("${text}")
