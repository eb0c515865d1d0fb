# How the folders below declare their programs. Every entry of ctest has a limit that a machine four times slower than two
# idle cores still meets: it is there for what hangs, never for what is slow.

find_package(GTest REQUIRED)
find_package(rapidcheck QUIET)

# Tests compile in half the time without optimization, and most of them wait for the program anyway. OPTIMIZED is for those
# that compute by themselves (-O1): references in float64, pictures of many pixels.

# Cache of compiled shader programs, shared by all tests that draw.
set(vitrine_program_caches ${PROJECT_BINARY_DIR}/tests/exhibits/caches/llvmpipe)
file(MAKE_DIRECTORY ${vitrine_program_caches})
# Environment of what draws.
set(vitrine_drawing LIBGL_ALWAYS_SOFTWARE=1 XDG_CACHE_HOME=${vitrine_program_caches})

# vitrine_under_x(<variable> <width>x<height> [<command>...]): the command that runs another one on an X server of its own, with a
# screen of this size; empty without xvfb-run. By default an X server starts anew when its last client has gone, and then also
# cuts off a program that connects at that moment.
find_program(XVFB_RUN xvfb-run)
function(vitrine_under_x variable size)
    if(XVFB_RUN)
        set(${variable} ${XVFB_RUN} -a -s "-screen 0 ${size}x24 -noreset" ${ARGN} PARENT_SCOPE)
    else()
        set(${variable} PARENT_SCOPE)
    endif()
endfunction()

# Precompiled headers of other libraries for most tests: one set for all programs, and one for those with OPTIMIZED.
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/headers.cpp "")
foreach(headers vitrine_test_headers vitrine_optimized_test_headers)
    add_library(${headers} STATIC ${CMAKE_CURRENT_BINARY_DIR}/headers.cpp)
    target_link_libraries(${headers} PRIVATE vitrine_options glm::glm nlohmann_json::nlohmann_json GTest::gtest)
    target_precompile_headers(${headers} PRIVATE <gtest/gtest.h> <glm/glm.hpp> <nlohmann/json.hpp> <algorithm> <cmath>
                              <filesystem> <fstream> <functional> <map> <memory> <random> <regex> <string> <vector>)
    target_compile_options(${headers} PRIVATE -fPIC)  # As Qt 6.4 asks of what links it: one way for all programs.
endforeach()
target_compile_options(vitrine_test_headers PRIVATE ${vitrine_unoptimized})
target_compile_options(vitrine_optimized_test_headers PRIVATE ${vitrine_little_optimized})

# vitrine_program_first(<name> <library>...): the linker keeps the first definition of an inline function or template, and the
# tests define those of GLM and the standard library without optimization. The program's own archives before the tests' files
# let the program run as it is shipped: planning all presets takes six tenths of the time.
function(vitrine_program_first name)
    set(archives)
    foreach(library vitrine_ui vitrine_exhibits vitrine_render)
        if(archives OR library IN_LIST ARGN OR (library STREQUAL vitrine_exhibits AND vitrine_gl_test_support IN_LIST ARGN))
            list(APPEND archives $<TARGET_FILE:${library}>)
        endif()
    endforeach()
    if(archives AND CMAKE_BUILD_TYPE STREQUAL "Release")
        target_link_options(${name} PRIVATE LINKER:--whole-archive ${archives} LINKER:--no-whole-archive)
    endif()
endfunction()

# vitrine_gtest_program(<name> [OPTIMIZED] SOURCES <file>... [LIBRARIES <target>...]): a GoogleTest program that ctest knows
# nothing of yet.
function(vitrine_gtest_program name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "OPTIMIZED" "" "SOURCES;LIBRARIES")
    add_executable(${name} ${arg_SOURCES})
    target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} GTest::gtest GTest::gtest_main)
    target_compile_definitions(${name} PRIVATE VITRINE_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                               VITRINE_PROGRAM="${PROJECT_BINARY_DIR}/vitrine")
    vitrine_program_first(${name} ${arg_LIBRARIES})
    target_compile_options(${name} PRIVATE -fPIC)
    if(arg_OPTIMIZED)
        target_compile_options(${name} PRIVATE ${vitrine_little_optimized})
        target_precompile_headers(${name} REUSE_FROM vitrine_optimized_test_headers)
    else()
        target_compile_options(${name} PRIVATE ${vitrine_unoptimized})
        target_precompile_headers(${name} REUSE_FROM vitrine_test_headers)
    endif()
    set_target_properties(${name} PROPERTIES
                          RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/tests
                          UNITY_BUILD ${VITRINE_UNITY_BUILD} VITRINE_TESTS_TOGETHER ${VITRINE_UNITY_BUILD})
    # Fixtures of one file each.
    target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction()

# vitrine_test(<name> [OPTIMIZED] LABELS <label>... SOURCES <file>... [LIBRARIES <target>...]): a GoogleTest program, one
# entry of ctest. Suites whose names begin with Long are an entry of their own, <name>_long, with the label long.
function(vitrine_test name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "OPTIMIZED" "" "LABELS;SOURCES;LIBRARIES")
    set(optimized)
    if(arg_OPTIMIZED)
        set(optimized OPTIMIZED)
    endif()
    vitrine_gtest_program(${name} ${optimized} SOURCES ${arg_SOURCES} LIBRARIES ${arg_LIBRARIES})
    add_test(NAME ${name} COMMAND ${name} --gtest_filter=-Long*:*/Long*)
    set_tests_properties(${name} PROPERTIES LABELS "${arg_LABELS}")
    set(entries ${name})
    foreach(source IN LISTS arg_SOURCES)
        file(STRINGS ${source} long_tests REGEX "^TEST(_F|_P)?\\(Long[A-Z]")
        if(long_tests AND NOT TEST ${name}_long)
            add_test(NAME ${name}_long COMMAND ${name} --gtest_filter=Long*:*/Long*)
            set_tests_properties(${name}_long PROPERTIES LABELS "${arg_LABELS};long")
            list(APPEND entries ${name}_long)
        endif()
    endforeach()
    set_tests_properties(${entries} PROPERTIES TIMEOUT 1200
                         ENVIRONMENT "${vitrine_drawing}")
endfunction()

# vitrine_suites(<program> [AS <name>] [LONG <regex>] LABELS <label>... [PROPERTIES <key> <value>...]
# [ENVIRONMENT <name=value>...]): an entry <name>.<suite> for each suite of a GoogleTest program, and for each parameter of a
# suite with parameters; those that begin with Long or match LONG have the label long besides. ENVIRONMENT stands in place of
# ${vitrine_drawing}. They are listed when ctest starts, so that what is new in the program needs no line here. ctest starts
# what has the highest COST first, and COST counts for all entries of a call: the seconds that the longest takes.
function(vitrine_suites program)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "AS;LONG" "LABELS;PROPERTIES;ENVIRONMENT")
    if(NOT arg_AS)
        set(arg_AS ${program})
    endif()
    if(NOT arg_ENVIRONMENT)
        set(arg_ENVIRONMENT ${vitrine_drawing})
    endif()
    set(listing ${CMAKE_CURRENT_BINARY_DIR}/${arg_AS}_suites.cmake)
    file(GENERATE OUTPUT ${listing} CONTENT
"set(program [==[$<TARGET_FILE:${program}>]==])
set(name [==[${arg_AS}]==])
set(labels [==[${arg_LABELS}]==])
set(long [==[${arg_LONG}]==])
set(environment [==[${arg_ENVIRONMENT}]==])
set(properties [==[${arg_PROPERTIES}]==])
include([==[${PROJECT_SOURCE_DIR}/tests/list_suites.cmake]==])
")
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${listing})
endfunction()
