# How everything is compiled. Motion must have the same bits on every run of one build, so nothing
# here may let the compiler reorder, fuse or approximate floating-point operations.
#
# Warnings are errors for us (presets dev, asan, tsan, and CI), not for a user with another compiler.
option(WARNINGS_ARE_ERRORS "Stop the build at a warning" OFF)
add_compile_options(
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual $<$<BOOL:${WARNINGS_ARE_ERRORS}>:-Werror>
    -ffp-contract=off -fno-fast-math -fvisibility=hidden)

# g++ 12 warns at -O2 of reads and writes beyond strings and vectors of the standard library that are none
# (its bugs 105329, 105651): what it says at -O1 and what the sanitizers find still counts.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_FLAGS MATCHES "-O[23]")
    add_compile_options(-Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread
        -Wno-maybe-uninitialized)
endif()

# The compiler spends two thirds of its time on headers: eight sources of a module at once take half the time. ./run
# and .ci/run build so, once, from nothing; whoever changes a source waits less when it is compiled alone. A name of
# one source's unnamed namespace is then also seen by the next: two warnings are about that alone.
option(SOURCES_TOGETHER "Compile eight sources of a module at once: quick from nothing, slow after an edit" OFF)
if(SOURCES_TOGETHER AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    add_compile_options(-Wno-shadow -Wshadow=local -Wno-subobject-linkage)
endif()

set(SANITIZE "" CACHE STRING "Sanitizers to build with, as for -fsanitize= (address,undefined or thread)")
if(SANITIZE)
    # The checks that a sanitizer puts in hide from g++ that a value was set: it warns of values that are.
    add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    add_compile_options(-fsanitize=${SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    add_link_options(-fsanitize=${SANITIZE})
endif()

option(FUZZ "Tell clang's libFuzzer which branches are taken (preset fuzz)" OFF)
if(FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link)
endif()

option(COMPILER_CACHE "Compile through ccache, where it is installed" ON)
find_program(CCACHE ccache)
if(CCACHE AND COMPILER_CACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER
        ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
        CCACHE_INODECACHE=1 # a precompiled header of 360 MB is hashed once, not for each source
        CCACHE_NOHASHDIR=1 CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} ${CCACHE})
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
        add_compile_options(-fpch-preprocess)
    else()
        add_compile_options("SHELL:-Xclang -fno-pch-timestamp")
    endif()
endif()
