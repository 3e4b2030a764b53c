# Debian packages: `cpack --config build/CPackConfig.cmake` makes tread (the program with vehicles and scenarios),
# python3-tread (the Python package) and libtread-dev (headers and libraries for Bullet in both precisions, found by CMake
# and pkg-config).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME tread)
set(CPACK_PACKAGE_CONTACT "the tread developers <tread@localhost>")
set(CPACK_PACKAGE_VENDOR tread)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES TRUE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_CURRENT_SOURCE_DIR}/LICENSE)
set(CPACK_DEB_COMPONENT_INSTALL TRUE)
set(CPACK_COMPONENTS_ALL development)
if(TREAD_LAB)
    list(APPEND CPACK_COMPONENTS_ALL program)
endif()
if(TREAD_PYTHON)
    list(APPEND CPACK_COMPONENTS_ALL python)
    # The module is for one version of Python, as its name says.
    math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}), python3 (<< ${Python3_VERSION_MAJOR}.${next_minor}), python3-numpy, tread (= ${PROJECT_VERSION})")
endif()
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-tread)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
    "full-vehicle simulator on Delft Tyre 97, for Python\n import tread: runs, logs as NumPy arrays, metrics, tyre forces, diagnosis, campaigns, cars in steps.")

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME tread)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
if(TREAD_LAB)
    # dpkg-shlibdeps cannot see this dependency: matio is loaded, not linked.
    cmake_path(GET matio_file PARENT_PATH matio_folder)
    find_program(TREAD_DPKG_QUERY dpkg-query)
    if(TREAD_DPKG_QUERY)
        execute_process(COMMAND ${TREAD_DPKG_QUERY} --search ${matio_folder}/${tread_matio} OUTPUT_VARIABLE matio_owner ERROR_QUIET)
        string(REGEX MATCH "^[^:]+" CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${matio_owner}")
    endif()
endif()
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
    "full-vehicle simulator on Delft Tyre 97\n Runs standard manoeuvres headless, computes their metrics, compares and reports logs.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libtread-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libbullet-dev, libeigen3-dev, libyaml-cpp-dev, pkg-config")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
    "full-vehicle simulator on Delft Tyre 97, for Bullet programs\n A vehicle action and a replacement of btRaycastVehicle, for Bullet in single and double precision.")
include(CPack)
