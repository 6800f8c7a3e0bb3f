# cmake --install: the command with its second checker, the rooms with their headers, the Python module, and what
# tools/packaging/build made (manual, completions, site).  C++ programs use find_package(kovacic CONFIG), link
# kov::integrability (or any one room) and include "room/name.hpp"; or pkg-config kovacic.
include(CMakePackageConfigHelpers)
set(config_dir lib/cmake/kovacic)
install(TARGETS kovacic RUNTIME COMPONENT command)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tools/verify/ DESTINATION share/kovacic/verify COMPONENT command
        USE_SOURCE_PERMISSIONS FILES_MATCHING PATTERN "*.py")
install(FILES ${PROJECT_SOURCE_DIR}/docs/theory/rules.toml DESTINATION share/kovacic/verify COMPONENT command)
file(CREATE_LINK ../share/kovacic/verify/kovacic_verify.py ${CMAKE_BINARY_DIR}/kovacic-verify SYMBOLIC)
install(FILES ${CMAKE_BINARY_DIR}/kovacic-verify DESTINATION bin COMPONENT command)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/cases DESTINATION share/doc/kovacic-doc/examples COMPONENT documentation)

install(TARGETS kov_warnings EXPORT kovacic COMPONENT development)
install(EXPORT kovacic NAMESPACE kov:: DESTINATION ${config_dir} FILE kovacicTargets.cmake COMPONENT development)
file(WRITE ${CMAKE_BINARY_DIR}/kovacicConfig.cmake [[
include(CMakeFindDependencyMacro)
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
find_dependency(Threads)
find_dependency(Flint)
find_dependency(Z3)
find_dependency(nlohmann_json)
find_dependency(PkgConfig)
pkg_check_modules(ginac REQUIRED IMPORTED_TARGET ginac)
pkg_check_modules(nettle REQUIRED IMPORTED_TARGET nettle)
include(${CMAKE_CURRENT_LIST_DIR}/kovacicTargets.cmake)
]])
write_basic_package_version_file(${CMAKE_BINARY_DIR}/kovacicConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/kovacicConfig.cmake ${CMAKE_BINARY_DIR}/kovacicConfigVersion.cmake
        ${PROJECT_SOURCE_DIR}/tools/cmake/FindFlint.cmake ${PROJECT_SOURCE_DIR}/tools/cmake/FindZ3.cmake
        DESTINATION ${config_dir} COMPONENT development)

# pkg-config: all rooms in one group, since it knows no order among them; it finds itself, wherever it is installed.
get_property(rooms GLOBAL PROPERTY KOV_ROOMS)
list(TRANSFORM rooms PREPEND "-lkov_" OUTPUT_VARIABLE libraries)
list(JOIN libraries " " libraries)
file(WRITE ${CMAKE_BINARY_DIR}/kovacic.pc "prefix=\${pcfiledir}/../..
Name: kovacic
Description: ${PROJECT_DESCRIPTION}
Version: ${PROJECT_VERSION}
Requires: ginac nettle
Cflags: -std=c++20 -ffp-contract=off -I\${prefix}/include/kovacic
Libs: -L\${prefix}/lib -Wl,--start-group ${libraries} -Wl,--end-group -lcalcium -lantic -lflint-arb -lflint -lmpfr -lgmp -lz3 -pthread
")
install(FILES ${CMAKE_BINARY_DIR}/kovacic.pc DESTINATION lib/pkgconfig COMPONENT development)

# What tools/packaging/build made, if it ran.
set(made ${CMAKE_BINARY_DIR}/packaging)
install(DIRECTORY ${made}/man DESTINATION share COMPONENT command OPTIONAL)
install(FILES ${made}/kovacic DESTINATION share/bash-completion/completions COMPONENT command OPTIONAL)
install(FILES ${made}/_kovacic DESTINATION share/zsh/vendor-completions COMPONENT command OPTIONAL)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/build/site/ DESTINATION share/doc/kovacic-doc/html COMPONENT documentation OPTIONAL)
include(${PROJECT_SOURCE_DIR}/tools/packaging/Packages.cmake)
