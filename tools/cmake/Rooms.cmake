# A room of lib/ is one CMake target that links only what it may use, so that a forbidden include does
# not compile.  kov_room(exact LINKS flint::flint) makes the library kov::exact from lib/exact/*.cpp.

# What nearly every file reads before its own first line is read once: half of the build was that.  The preset
# `dev` does without, so that a missing include is seen.
option(KOV_PRECOMPILE "Precompiled headers" ON)
set(kov_standard_headers <algorithm> <array> <chrono> <cstdint> <functional> <map> <memory> <numeric> <optional>
    <set> <sstream> <stdexcept> <string> <string_view> <utility> <variant> <vector>)
# kov_precompile(TARGET HEADER...), or kov_precompile(TARGET REUSE OTHER_TARGET)
function(kov_precompile target)
  if(NOT KOV_PRECOMPILE)
    return()
  endif()
  if(ARGV1 STREQUAL REUSE)
    target_precompile_headers(${target} REUSE_FROM ${ARGV2})
  else()
    list(TRANSFORM ARGN REPLACE "<(.+)>" "$<$<COMPILE_LANGUAGE:CXX>:<\\1$<ANGLE-R>>")
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# The files of a folder are compiled together, up to so many bytes: most of what the compiler does for one of them
# is the same for its neighbours.  The preset `dev` compiles each alone, so that each is seen to include what it uses.
option(KOV_UNITY "Compile the files of a folder together" ON)

add_library(kov_warnings INTERFACE)
target_compile_options(kov_warnings INTERFACE
  # -Wshadow means nothing between files that are compiled together
  $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic $<$<NOT:$<BOOL:${KOV_UNITY}>>:-Wshadow> -Wconversion -Wno-sign-conversion
  # g++ 12 sees overlaps in std::string operator+ that are not there (GCC PR105329)
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # and from a precompiled header it does not know that <string> is a system header
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${KOV_PRECOMPILE}>>:-Wno-array-bounds;-Wno-stringop-overflow>>)
if(KOV_WERROR)
  target_compile_options(kov_warnings INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Werror>)
endif()
if(KOV_SANITIZE)
  add_compile_options(-fsanitize=${KOV_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${KOV_SANITIZE})
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
endif()

if(KOV_COVERAGE)
  add_compile_options(--coverage)
  add_link_options(--coverage)
endif()

if(KOV_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# The sources of a folder and of its own folders; without any, the list of rooms and the tree disagree.
function(kov_sources out folder)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp ${folder}/*.c ${folder}/*/*.cpp ${folder}/*/*.c)
  if(NOT sources)
    message(FATAL_ERROR "${folder} has no sources: remove it from the list, or furnish it")
  endif()
  set(${out} ${sources} PARENT_SCOPE)
endfunction()

# Where the time of a run goes is compiled with -O2, the rest with -O1, which compiles twice as fast: the long
# loops of those rooms are FLINT's, Arb's and Z3's, and those of lib/exact.  What asks the others and writes answers is
# compiled faster still (-Og instead of -O1: 7 % of the first build, 2 to 5 % of a run).
set(kov_hot_rooms exact linode kovacic riccati invariant pcurvature galois monodromy flow)
set(kov_writing_rooms report theorem splitting literature symbol equation system study main command_line
    integrability classify moves canonical manifold variation algebraize jets quadratures decide pullback closed certify proof)
function(kov_optimize target name)
  if(NOT CMAKE_BUILD_TYPE STREQUAL Release OR name IN_LIST kov_hot_rooms)
    return()
  elseif(name IN_LIST kov_writing_rooms)
    target_compile_options(${target} PRIVATE -Og)
  else()
    target_compile_options(${target} PRIVATE -O1)
  endif()
endfunction()

set(kov_unity_bytes 200000)
function(kov_unity target)
  if(NOT KOV_UNITY)
    return()
  endif()
  set(folder)
  foreach(source ${ARGN})
    if(NOT source MATCHES "\\.cpp$")
      set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
      continue()
    endif()
    get_filename_component(source ${source} ABSOLUTE)
    get_filename_component(of ${source} DIRECTORY)
    if(EXISTS ${source})
      file(SIZE ${source} bytes)
    else() # generated
      set(bytes 20000)
    endif()
    math(EXPR together "${together} + ${bytes}")
    if(NOT folder OR (NOT of STREQUAL folder AND NOT target STREQUAL kov_command_line) OR together GREATER kov_unity_bytes)
      math(EXPR group "${group} + 1")
      set(folder ${of})
      set(together ${bytes})
    endif()
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# The first room of each kind owns a precompiled header; the others of its kind reuse it.
function(kov_precompile_room name)
  set(kind other)
  foreach(list hot writing)
    if(name IN_LIST kov_${list}_rooms)
      set(kind ${list})
    endif()
  endforeach()
  get_property(owner GLOBAL PROPERTY KOV_PRECOMPILED_${kind})
  if(owner)
    kov_precompile(kov_${name} REUSE ${owner})
  else()
    kov_precompile(kov_${name} ${kov_standard_headers} <arb.h> <flint/fmpq_poly.h> <antic/nf_elem.h>)
    set_property(GLOBAL PROPERTY KOV_PRECOMPILED_${kind} kov_${name})
  endif()
endfunction()

function(kov_room name)
  cmake_parse_arguments(ROOM "" "" "LINKS;PRIVATE_LINKS" ${ARGN})
  kov_sources(sources ${CMAKE_CURRENT_SOURCE_DIR}/${name})
  add_library(kov_${name} STATIC ${sources})
  add_library(kov::${name} ALIAS kov_${name})
  # Each room sees the headers of the rooms that it links, under include/<room>/, and no others.
  set(view ${CMAKE_BINARY_DIR}/rooms/${name})
  file(MAKE_DIRECTORY ${view})
  file(CREATE_LINK ${CMAKE_CURRENT_SOURCE_DIR}/${name} ${view}/${name} SYMBOLIC)
  target_include_directories(kov_${name} PUBLIC $<BUILD_INTERFACE:${view}> $<INSTALL_INTERFACE:include/kovacic>)
  target_link_libraries(kov_${name} PUBLIC ${ROOM_LINKS} PRIVATE ${ROOM_PRIVATE_LINKS} kov_warnings)
  set_target_properties(kov_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON EXPORT_NAME ${name})
  kov_optimize(kov_${name} ${name})
  if(name STREQUAL flow) # compiled with other options
    kov_precompile(kov_flow ${kov_standard_headers})
  else()
    kov_unity(kov_${name} ${sources})
    kov_precompile_room(${name})
  endif()
  set_property(GLOBAL APPEND PROPERTY KOV_ROOMS ${name})
  install(TARGETS kov_${name} EXPORT kovacic COMPONENT development)
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/${name} DESTINATION include/kovacic COMPONENT development
          FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h")
endfunction()

# kov_tests(exact LINKS kov::exact) makes the test program of one room from tests/exact/*.cpp.
function(kov_tests name)
  kov_sources(sources ${CMAKE_CURRENT_SOURCE_DIR}/${name})
  kov_test_program(${name} ${sources} ${ARGN})
endfunction()

# kov_test_program(NAME SOURCE... LINKS kov::exact [LABELS slow])
function(kov_test_program name)
  cmake_parse_arguments(TESTS "" "" "LINKS;LABELS" ${ARGN})
  add_executable(test_${name} ${TESTS_UNPARSED_ARGUMENTS})
  target_link_libraries(test_${name} PRIVATE ${TESTS_LINKS} kov_warnings kov_test_source_dir GTest::gmock
                        GTest::gtest_main)
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  if(name IN_LIST kov_tests_together)
    kov_unity(test_${name} ${TESTS_UNPARSED_ARGUMENTS})
  endif()
  if(NOT TESTS_LINKS MATCHES "kov::(flow|command_line)") # compiled with other options
    kov_precompile(test_${name} REUSE kov_test_source_dir)
  endif()
  if(NOT TESTS_LABELS)
    set(TESTS_LABELS quick)
  endif()
  gtest_discover_tests(test_${name} TEST_PREFIX "${name}/" DISCOVERY_TIMEOUT 60
                       PROPERTIES LABELS "${TESTS_LABELS}" TIMEOUT 600)
endfunction()

# The files of FOLDER as text_files() and text_file(NAME) of a namespace, in the target; its sources declare them.
function(kov_texts target folder namespace)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS ${folder}/*)
  set(out ${CMAKE_CURRENT_BINARY_DIR}/${target}_texts.cpp)
  set(script ${PROJECT_SOURCE_DIR}/tools/cmake/texts.cmake)
  add_custom_command(OUTPUT ${out} DEPENDS ${files} ${script}
    COMMAND ${CMAKE_COMMAND} -DFOLDER=${folder} -DNAMESPACE=${namespace} -DOUT=${out} -P ${script})
  target_sources(${target} PRIVATE ${out})
endfunction()
