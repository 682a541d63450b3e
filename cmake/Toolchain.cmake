# Language level, warnings, sanitizers, compiler cache and linker, once for the whole tree.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
set(CMAKE_C_FLAGS_RELEASE "-O2 -DNDEBUG")
set(CMAKE_CXX_FLAGS_DEV "-O1 -g1")
set(CMAKE_C_FLAGS_DEV "-O1 -g1")

set(VESTIGE_SANITIZE "" CACHE STRING "Sanitizers, as for -fsanitize=")
if(VESTIGE_SANITIZE)
    add_compile_options("-fsanitize=${VESTIGE_SANITIZE}" -fno-omit-frame-pointer -fno-sanitize-recover=all)
    add_link_options("-fsanitize=${VESTIGE_SANITIZE}")
endif()

# The instruction set that every machine we support has (docs/decisions/0006-instruction-set-floor.md); the programs check
# it as they start. Eigen keeps the alignment of the distribution's PCL, which is built for less.
add_compile_options(-march=x86-64-v3)
add_compile_definitions(EIGEN_MAX_ALIGN_BYTES=16)
# Contracted multiply-adds would make results depend on the processor that the build targets.
add_compile_options(-ffp-contract=off)
# GCC 12 at -O2 drops the rounding of a double to float and back when it vectorises neighbouring statements
# (docs/decisions/0002-no-slp-vectoriser.md).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-fno-tree-slp-vectorize)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
    set(launcher "${CMAKE_COMMAND}" -E env "CCACHE_BASEDIR=${CMAKE_SOURCE_DIR}" CCACHE_NOHASHDIR=1
        "CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime" "${CCACHE_PROGRAM}")
    set(CMAKE_CXX_COMPILER_LAUNCHER "${launcher}")
    set(CMAKE_C_COMPILER_LAUNCHER "${launcher}")
endif()
find_program(LLD_PROGRAM ld.lld)
if(LLD_PROGRAM)
    add_link_options(-fuse-ld=lld)
endif()

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
