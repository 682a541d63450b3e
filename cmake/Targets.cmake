# One function per kind of target, so that a room's CMakeLists.txt names sources and what it may see, nothing else.

function(vestige_defaults target)
    target_include_directories(${target} PUBLIC "${CMAKE_SOURCE_DIR}" "${CMAKE_BINARY_DIR}/generated")
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wnon-virtual-dtor
        -Woverloaded-virtual)
    # Warnings are errors of the compiler that we ship with; clang builds the fuzz targets alone.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(${target} PRIVATE -Wshadow=local -Werror)
    endif()
endfunction()

# vestige_library(NAME SOURCES ... [USES public targets] [PRIVATE foreign libraries] [NO_PCH])
function(vestige_library name)
    cmake_parse_arguments(arg "NO_PCH" "" "SOURCES;USES;PRIVATE" ${ARGN})
    add_library(vestige_${name} STATIC ${arg_SOURCES})
    vestige_defaults(vestige_${name})
    target_link_libraries(vestige_${name} PUBLIC ${arg_USES} PRIVATE ${arg_PRIVATE})
    if(NOT arg_NO_PCH AND NOT name STREQUAL "base")
        target_precompile_headers(vestige_${name} REUSE_FROM vestige_base)
    endif()
endfunction()

# vestige_test(NAME SOURCES ... USES ...): one GoogleTest program of a room, each case a ctest of label core, ui or cli.
function(vestige_test name)
    cmake_parse_arguments(arg "" "LABEL;TIMEOUT" "SOURCES;USES" ${ARGN})
    if(NOT arg_LABEL)
        set(arg_LABEL core)
    endif()
    if(NOT arg_TIMEOUT)
        set(arg_TIMEOUT 300)
    endif()
    add_executable(test_${name} ${arg_SOURCES})
    vestige_defaults(test_${name})
    target_link_libraries(test_${name} PRIVATE vestige_test_support ${arg_USES} GTest::gtest GTest::gtest_main)
    add_test(NAME ${name} COMMAND test_${name})
    set_tests_properties(${name} PROPERTIES LABELS "${arg_LABEL}" TIMEOUT ${arg_TIMEOUT}
        SKIP_REGULAR_EXPRESSION "nothing to run")
endfunction()
