# Code that must not compile. trembler_compile_fail(NAME SOURCE EXPECTED_REGEX) adds two cases:
#   compile_fail.NAME       the compiler refuses SOURCE and its message matches EXPECTED_REGEX
#   compile_fail.controls   with -DTREMBLER_CONTROL the files of all cases compile
# so that the first cannot succeed for a wrong reason, such as a missing header. Let the expression match words
# of ours, such as a static_assert's: the compilers' own messages differ. In the file the offending
# line is in `#ifndef TREMBLER_CONTROL`, next to the correct code of the control.
# Sanitizers find nothing here, so their builds omit these cases.
if(TREMBLER_SANITIZE)
  return()
endif()

# trembler_syntax_check(VARIABLE): the compiler's command line without the file to be checked.
function(trembler_syntax_check variable)
  # False conditions leave empty entries.
  set(includes $<FILTER:$<TARGET_PROPERTY:trembler_physics,INTERFACE_INCLUDE_DIRECTORIES>,EXCLUDE,^$>)
  set(defines $<FILTER:$<TARGET_PROPERTY:trembler_physics,INTERFACE_COMPILE_DEFINITIONS>,EXCLUDE,^$>)
  # Carets are off because the quoted source line could match the expression by itself.
  set(no_carets -fno-diagnostics-show-caret)
  if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
    set(no_carets -fno-caret-diagnostics)
  endif()
  set(${variable} ${CMAKE_CXX_COMPILER} -std=c++20 ${no_carets}
    "$<$<BOOL:${includes}>:-I$<JOIN:${includes},$<SEMICOLON>-I>>"
    "$<$<BOOL:${defines}>:-D$<JOIN:${defines},$<SEMICOLON>-D>>" PARENT_SCOPE)
endfunction()

# Most cases begin with kit.hpp, and reading its includes takes most of their time. So it is compiled once, before
# the cases and whenever they run. g++ looks for a compiled header, under the name with .gch, wherever it looks for the
# header itself, and ignores one made with other options.
set(trembler_compiled_kit ${CMAKE_CURRENT_BINARY_DIR}/compile_fail_kit)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  file(MAKE_DIRECTORY ${trembler_compiled_kit}/tests/compile_fail)
  trembler_syntax_check(compile)
  add_test(NAME compile_fail.kit
    COMMAND ${compile} -w -x c++-header ${CMAKE_CURRENT_SOURCE_DIR}/compile_fail/kit.hpp
      -o ${trembler_compiled_kit}/tests/compile_fail/kit.hpp.gch
    COMMAND_EXPAND_LISTS)
  set_tests_properties(compile_fail.kit PROPERTIES LABELS compile_fail TIMEOUT 3600 FIXTURES_SETUP compile_fail_kit)
endif()

function(trembler_compile_fail name source expected_regex)
  trembler_syntax_check(compile)
  list(APPEND compile -fsyntax-only)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    list(INSERT compile 1 -I${trembler_compiled_kit})
  endif()
  set(script ${PROJECT_SOURCE_DIR}/cmake/TremblerMustNotCompile.cmake)
  set(file ${CMAKE_CURRENT_SOURCE_DIR}/compile_fail/${source})
  add_test(NAME compile_fail.${name}
    COMMAND ${CMAKE_COMMAND} "-DEXPECTED=${expected_regex}" -P ${script} -- ${compile} ${file}
    COMMAND_EXPAND_LISTS)
  set_tests_properties(compile_fail.${name} PROPERTIES
    LABELS compile_fail TIMEOUT 3600 FIXTURES_REQUIRED compile_fail_kit)
  set(trembler_controls ${trembler_controls} ${file} PARENT_SCOPE)
endfunction()

trembler_compile_fail(sample sample.cpp "a sample refuses by design")

trembler_compile_fail(resolver_undeclared_read resolver/undeclared_read.cpp
  "undeclared read: the property is in neither Reads<> nor Writes<> of this resolver")
trembler_compile_fail(resolver_undeclared_write resolver/undeclared_write.cpp
  "undeclared write: the property is not in Writes<> of this resolver")
trembler_compile_fail(resolver_undeclared_provide resolver/undeclared_provide.cpp
  "undeclared: the resolver property is not in Provides<> of this resolver")
trembler_compile_fail(resolver_reads_derived resolver/reads_derived.cpp
  "a resolver may read object properties only")
trembler_compile_fail(resolver_reads_resolver resolver/reads_resolver.cpp
  "a resolver may read object properties only")
trembler_compile_fail(resolver_offers_derived resolver/offers_derived.cpp
  "a resolver must declare Reads<...>, Writes<...>, Provides<...>")
trembler_compile_fail(resolver_takes_the_store resolver/takes_the_store.cpp
  "only a resolver with .static constexpr bool writesEverything = true. may take the whole store")

trembler_compile_fail(dps_undeclared_read dps/undeclared_read.cpp
  "undeclared read: the property is not in Reads<> of this derived property set")
trembler_compile_fail(dps_writes dps/writes.cpp "a derived property set may not write a property")
trembler_compile_fail(dps_derives_undeclared dps/derives_undeclared.cpp
  "undeclared: the derived property is not in Derives<> of this derived property set")
trembler_compile_fail(dps_reads_dps dps/reads_dps.cpp "a derived property set may not read derived properties")
trembler_compile_fail(dps_reads_dps_in_disguise dps/reads_dps_in_disguise.cpp
  "a derived property set must declare Reads<...>, Derives<...>, in this order, and may write nothing else")
trembler_compile_fail(dps_changes_resolver_property dps/changes_resolver_property.cpp
  "a derived property set must declare Reads<...>, Derives<...>, in this order, and may write nothing else")
# The compilers' own message: a function cannot have a message of ours.
trembler_compile_fail(dps_overrides_bind dps/overrides_bind.cpp
  "overriding final function|overrides a 'final' function")

trembler_compile_fail(interaction_undeclared_read interaction/undeclared_read.cpp
  "undeclared read: the property is not in Reads<> of this interaction")
trembler_compile_fail(interaction_writes interaction/writes.cpp
  "an interaction may not write a property: call the resolver that writes it")
trembler_compile_fail(interaction_calls_second_resolver interaction/calls_second_resolver.cpp
  "an interaction may call functions of the one role that it declares only")

trembler_compile_fail(call_without_description call_without_description.cpp "describes its arguments")
trembler_compile_fail(call_without_algebra call_without_algebra.cpp
  "a call must have .static constexpr Algebra algebra.")
trembler_compile_fail(counted_set_without_delta counted_set_without_delta.cpp
  "a call on a counted set must return the change of the count: delta")
trembler_compile_fail(any_of_without_key any_of_without_key.cpp
  "must return the key by which calls are combined: key")

trembler_compile_fail(completion_undeclared_read completion/undeclared_read.cpp
  "undeclared read: the property is not in Reads<> of this completion")
trembler_compile_fail(completion_undeclared_add completion/undeclared_add.cpp
  "undeclared addition: the property is not in Adds<> of this completion")
trembler_compile_fail(completion_adds_resolver_property completion/adds_resolver_property.cpp
  "a completion adds object properties only")
trembler_compile_fail(completion_reads_resolver_property completion/reads_resolver_property.cpp
  "a completion may read object properties only")
trembler_compile_fail(completion_reads_what_it_adds completion/reads_what_it_adds.cpp
  "a completion must not read a property that it adds")
trembler_compile_fail(completion_takes_the_store completion/takes_the_store.cpp
  "a completion must define .static void complete")
trembler_compile_fail(completion_in_disguise completion/in_disguise.cpp
  "a completion must be derived from Completion<Self, Reads<...>, Adds<...>>")
trembler_compile_fail(setup_reads_derived setup_reads_derived.cpp
  "an interaction that runs in the setup may read object properties only")

trembler_compile_fail(object_property_without_fields object_property_without_fields.cpp
  "an object property with members that level files may state must describe them")
trembler_compile_fail(slot_without_coverage slot_without_coverage.cpp
  "a resolver property must declare how the state hash covers it")
trembler_compile_fail(offer_without_news offer_without_news.cpp
  "an offered property must have exactly one of .static void gather")
trembler_compile_fail(offer_with_both offer_with_both.cpp
  "an offered property must have exactly one of .static void gather")
trembler_compile_fail(dps_derives_of_news dps/derives_of_news.cpp
  "an offered property must have exactly one of .static void gather")
trembler_compile_fail(component_without_coverage component_without_coverage.cpp
  "a component with data members must declare how the state hash covers them")
trembler_compile_fail(closed_role_is_fed closed_role_is_fed.cpp "only interactions may call this role")
trembler_compile_fail(interaction_calls_in_sequence interaction/calls_in_sequence.cpp
  "an interaction may not make a call with Algebra::sequence")
trembler_compile_fail(sequence_without_feeder sequence_without_feeder.cpp
  "a role with such calls must name their source in fedBy")
trembler_compile_fail(object_property_wanted object_property_wanted.cpp
  "want.. takes a resolver or derived property. object properties always exist")
# The compilers' own messages again, for private, const and deleted members.
trembler_compile_fail(caller_forged caller_forged.cpp "caller_.*private|private.*caller_")
trembler_compile_fail(onlooker_changes_world onlooker_changes_world.cpp
  "discards qualifiers|not marked const")
trembler_compile_fail(subscription_copied subscription_copied.cpp "deleted")

include(TremblerJoined)
trembler_joined(${CMAKE_CURRENT_BINARY_DIR}/compile_fail_controls.cpp ${trembler_controls})
trembler_syntax_check(compile)
add_test(NAME compile_fail.controls
  COMMAND ${compile} -fsyntax-only -DTREMBLER_CONTROL ${CMAKE_CURRENT_BINARY_DIR}/compile_fail_controls.cpp
  COMMAND_EXPAND_LISTS)
set_tests_properties(compile_fail.controls PROPERTIES LABELS compile_fail TIMEOUT 3600)
