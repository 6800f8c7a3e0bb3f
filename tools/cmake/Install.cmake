# cmake --install: the command, the rooms with their headers, and find_package(kovacic CONFIG) for proof
# scripts, which link kov::integrability (or any one room) and include "room/name.hpp".
include(CMakePackageConfigHelpers)
set(config_dir lib/cmake/kovacic)
install(TARGETS kovacic RUNTIME)
install(TARGETS kov_warnings EXPORT kovacic)
install(EXPORT kovacic NAMESPACE kov:: DESTINATION ${config_dir} FILE kovacicTargets.cmake)
file(WRITE ${CMAKE_BINARY_DIR}/kovacicConfig.cmake [[
include(CMakeFindDependencyMacro)
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
find_dependency(Threads)
find_dependency(Flint)
find_dependency(Z3)
find_dependency(PkgConfig)
pkg_check_modules(ginac REQUIRED IMPORTED_TARGET ginac)
include(${CMAKE_CURRENT_LIST_DIR}/kovacicTargets.cmake)
]])
write_basic_package_version_file(${CMAKE_BINARY_DIR}/kovacicConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/kovacicConfig.cmake ${CMAKE_BINARY_DIR}/kovacicConfigVersion.cmake
        ${PROJECT_SOURCE_DIR}/tools/cmake/FindFlint.cmake ${PROJECT_SOURCE_DIR}/tools/cmake/FindZ3.cmake DESTINATION ${config_dir})
