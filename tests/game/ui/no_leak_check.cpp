// Disables the leak checker of clang 14's AddressSanitizer in this program: it stops all threads at the
// program's end, and crashes with those of Mesa's software renderer. Leaks of the game are found by the tests
// without a window, leaks of drawing by test_render.

extern "C" int __lsan_is_turned_off() { // NOLINT(bugprone-reserved-identifier): its name is the sanitizer's
    return 1;
}
