# libFuzzer's programs: -DTREMBLER_FUZZERS=ON with clang++. See docs/security.md.
if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  message(FATAL_ERROR "TREMBLER_FUZZERS needs clang++, of which libFuzzer is a part")
endif()
target_compile_options(trembler_lua PRIVATE -fsanitize=fuzzer-no-link)
foreach(target script_text call_arguments level_edit)
  add_executable(fuzz_${target} EXCLUDE_FROM_ALL fuzz/engine/${target}_fuzzer.cpp fuzz/play.cpp fuzz/script_text.cpp
    fuzz/call_arguments.cpp fuzz/level_edit.cpp puzzle/edit/any_command.cpp)
  target_link_libraries(fuzz_${target} PRIVATE trembler_puzzle)
  target_compile_definitions(fuzz_${target} PRIVATE TREMBLER_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_compile_options(fuzz_${target} PRIVATE -fsanitize=fuzzer)
  target_link_options(fuzz_${target} PRIVATE -fsanitize=fuzzer)
endforeach()
