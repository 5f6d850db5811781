// Self-test of the test machinery: must fail to compile under its name and compile as the control.
#ifdef TREMBLER_CONTROL
constexpr bool allowed = true;
#else
constexpr bool allowed = false;
#endif

static_assert(allowed, "a sample refuses by design");
