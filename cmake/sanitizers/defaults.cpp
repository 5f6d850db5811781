// Linked into every program of a sanitizer build: how the sanitizers behave, and which reports about other
// libraries are left out.

extern "C" {

// Mesa's software driver leaves a leak that no suppression can name once the driver is unloaded: it stays
// loaded.
int dlclose(void* /*library*/) {
    return 0;
}

// Reports show the last twelve calls that led to an allocation: thirty, the default, take longer.
char const* __asan_default_options() {
    return "detect_stack_use_after_return=1:strict_string_checks=1:malloc_context_size=12";
}
char const* __ubsan_default_options() {
    return "print_stacktrace=1";
}
char const* __tsan_default_options() {
    return "halt_on_error=0:second_deadlock_stack=1";
}
char const* __lsan_default_suppressions() {
    return "leak:libdbus-1.so\n";
}

} // extern "C"
