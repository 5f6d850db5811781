// These tests must be heard by nobody, and must run the same on machines with and without sound.
#include <cstdlib>

namespace {

[[maybe_unused]] int const noDrivers = setenv("ALSOFT_DRIVERS", "none of these", 1);

} // namespace
