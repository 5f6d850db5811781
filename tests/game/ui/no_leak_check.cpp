// The leak checker of clang 14's AddressSanitizer, which stops all threads at the end of the program, crashes
// beside those of Mesa's software renderer. Leaks of the game are looked for in the tests without a window,
// of drawing in test_render.

extern "C" int __lsan_is_turned_off() { // NOLINT(bugprone-reserved-identifier): its name is the sanitizer's
    return 1;
}
