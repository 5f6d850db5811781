# Language, warnings and the flags that keep every build of the simulation bit-identical.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
# Asserts are enabled in every build: a broken invariant must not silently produce a wrong recording.
set(CMAKE_CXX_FLAGS_RELEASE "-O2")

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

add_library(trembler_options INTERFACE)
target_compile_options(trembler_options INTERFACE
  -Wall -Wextra -Wconversion
  # g++ 13's -Wdangling-reference reports any reference returned by a function that has a temporary as argument.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,13>>:-Wno-dangling-reference>
  # Fused multiply-add would round differently from one compiler, or one -march, to the next.
  -ffp-contract=off)
target_include_directories(trembler_options INTERFACE ${PROJECT_SOURCE_DIR})
if(TREMBLER_SANITIZE)
  target_compile_options(trembler_options INTERFACE
    -fsanitize=${TREMBLER_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
    $<$<BOOL:${TREMBLER_SANITIZE_LINES}>:-g1>)
  if(TREMBLER_SANITIZE MATCHES "undefined" AND CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    # clang++ inserts these four checks at each access, which takes a quarter of its time. The address sanitizer finds the
    # faults that "null" and "object-size" report, and x86-64 can read unaligned data.
    target_compile_options(trembler_options INTERFACE -fno-sanitize=alignment,null,object-size,vptr)
  endif()
  target_link_options(trembler_options INTERFACE -fsanitize=${TREMBLER_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang") # LLVM's linker takes a fraction of the time of the usual one
    include(CheckLinkerFlag)
    check_linker_flag(CXX -fuse-ld=lld TREMBLER_HAS_LLD)
    if(TREMBLER_HAS_LLD)
      target_link_options(trembler_options INTERFACE -fuse-ld=lld)
    endif()
  endif()
  add_library(trembler_sanitizer_defaults OBJECT cmake/sanitizers/defaults.cpp)
  target_link_libraries(trembler_options INTERFACE $<TARGET_OBJECTS:trembler_sanitizer_defaults>)
endif()

# trembler_sources(VARIABLE FOLDER...): every .cpp in the folders, subfolders included, in a stable order.
function(trembler_sources variable)
  set(found)
  foreach(folder ${ARGN})
    file(GLOB_RECURSE here CONFIGURE_DEPENDS ${folder}/*.cpp)
    list(APPEND found ${here})
  endforeach()
  list(SORT found)
  set(${variable} ${found} PARENT_SCOPE)
endfunction()

# Precompiled headers take as long to make and to load as they save where many files are compiled as one.
set(TREMBLER_PRECOMPILES OFF)
if(TREMBLER_PCH AND NOT TREMBLER_UNITY)
  set(TREMBLER_PRECOMPILES ON)
endif()

# trembler_unity(TARGET): with TREMBLER_UNITY, several files of the target are compiled as one, which halves the time of a
# full build but takes longer when one file has changed. Any two files of a target may be joined: names that the anonymous
# namespaces of two files share are put into a namespace named after the file.
function(trembler_unity target)
  if(TREMBLER_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON
      UNITY_BUILD_BATCH_SIZE ${TREMBLER_UNITY_BATCH})
    # Below 1.5 GB g++ collects no garbage, which takes 5 % of its time.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1500000>)
  endif()
endfunction()

# trembler_quick_with_sanitizers(TARGET): for code that takes little of the tests' time. clang++ spends two thirds of its
# time on optimising the code that the sanitizers insert.
function(trembler_quick_with_sanitizers target)
  if(TREMBLER_SANITIZE)
    target_compile_options(${target} PRIVATE -O0)
  endif()
endfunction()

# trembler_precompile(TARGET HEADER...): with TREMBLER_PRECOMPILES, parses these headers and common ones of the standard
# library only once for the whole target.
function(trembler_precompile target)
  if(TREMBLER_PRECOMPILES)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      target_compile_options(${target} PRIVATE -fpch-preprocess) # required by ccache
    else() # reproducible precompiled headers, so that clones share ccache's results
      target_compile_options(${target} PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
    endif()
    target_precompile_headers(${target} PRIVATE <algorithm> <array> <cmath> <functional> <map> <memory> <optional>
      <set> <span> <string> <unordered_map> <vector> <fmt/format.h> ${ARGN})
  endif()
endfunction()

# trembler_precompiled_as(TARGET OTHER): with TREMBLER_PRECOMPILES, uses the precompiled headers of OTHER.
function(trembler_precompiled_as target other)
  if(TREMBLER_PRECOMPILES)
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
    target_precompile_headers(${target} REUSE_FROM ${other})
  endif()
endfunction()
