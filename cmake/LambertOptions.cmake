# One interface target carries the compiler's settings to every module, test and program.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")

set(LAMBERT_SANITIZE "" CACHE STRING "Sanitizers, as in -fsanitize=… (address,undefined or thread)")

add_library(lambert_options INTERFACE)
target_compile_options(lambert_options INTERFACE
  -Wall -Wextra -Wconversion -Wshadow -Wdouble-promotion -Werror
  # members left out of designated initialisers have their defaults; that is their point
  -Wno-missing-field-initializers
  # false positives of GCC 12 on `"text" + std::string` (GCC bug 105651)
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  # AVX2 and FMA are the baseline; Embree picks AVX-512 itself where the machine has it.
  $<$<STREQUAL:${CMAKE_SYSTEM_PROCESSOR},x86_64>:-march=x86-64-v3>
  # math functions need not set errno; nothing here reads it, and sqrt becomes one instruction
  -fno-math-errno)
if(LAMBERT_SANITIZE)
  target_compile_options(lambert_options INTERFACE -fsanitize=${LAMBERT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(lambert_options INTERFACE -fsanitize=${LAMBERT_SANITIZE})
endif()

if(LAMBERT_FUZZ)
  target_compile_options(lambert_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  # without this it caches nothing that uses a precompiled header
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE_PROGRAM})
endif()
