# Code that must not compile. trembler_compile_fail(NAME SOURCE EXPECTED_REGEX) adds two cases:
#   compile_fail.NAME           the compiler refuses SOURCE and its message matches EXPECTED_REGEX
#   compile_fail.NAME.control   with -DTREMBLER_CONTROL the same file compiles
# so that the first cannot succeed for a wrong reason, such as a missing header. Let the expression match words
# of ours, such as a static_assert's: what compilers say themselves differs. In the file the offending
# line stands in `#ifndef TREMBLER_CONTROL`, next to what a well-behaved component would say instead.
# Sanitizers have nothing to add here, so that their builds leave these cases out.
function(trembler_compile_fail name source expected_regex)
  if(TREMBLER_SANITIZE)
    return()
  endif()
  # Conditions that do not hold leave empty entries behind.
  set(includes $<FILTER:$<TARGET_PROPERTY:trembler_physics,INTERFACE_INCLUDE_DIRECTORIES>,EXCLUDE,^$>)
  set(defines $<FILTER:$<TARGET_PROPERTY:trembler_physics,INTERFACE_COMPILE_DEFINITIONS>,EXCLUDE,^$>)
  # Carets are off because the quoted source line could match the expression by itself.
  set(compile ${CMAKE_CXX_COMPILER} -std=c++20 -fsyntax-only -fno-diagnostics-show-caret
    "$<$<BOOL:${includes}>:-I$<JOIN:${includes},$<SEMICOLON>-I>>"
    "$<$<BOOL:${defines}>:-D$<JOIN:${defines},$<SEMICOLON>-D>>")
  set(script ${PROJECT_SOURCE_DIR}/cmake/TremblerMustNotCompile.cmake)
  set(file ${CMAKE_CURRENT_SOURCE_DIR}/compile_fail/${source})
  add_test(NAME compile_fail.${name}
    COMMAND ${CMAKE_COMMAND} "-DEXPECTED=${expected_regex}" -P ${script} -- ${compile} ${file}
    COMMAND_EXPAND_LISTS)
  add_test(NAME compile_fail.${name}.control COMMAND ${compile} -DTREMBLER_CONTROL ${file}
    COMMAND_EXPAND_LISTS)
  set_tests_properties(compile_fail.${name} compile_fail.${name}.control PROPERTIES
    LABELS compile_fail TIMEOUT 120)
endfunction()

trembler_compile_fail(sample sample.cpp "a sample refuses by design")
