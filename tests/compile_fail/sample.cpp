// The machinery's own case: refused by name, and fine as the control.
#ifdef TREMBLER_CONTROL
constexpr bool allowed = true;
#else
constexpr bool allowed = false;
#endif

static_assert(allowed, "a sample refuses by design");
