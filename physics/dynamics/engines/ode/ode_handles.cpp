#ifdef TREMBLER_HAS_ODE
#include "physics/dynamics/engines/ode/ode_handles.hpp"

#include "physics/dynamics/core/engine_failure.hpp"

#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <stdexcept>

namespace trembler {
namespace {

// ODE calls this when an assertion has failed. It must not return.
void failed(int /*number*/, char const* message, va_list arguments) {
    std::array<char, 256> words{};
    std::vsnprintf(words.data(), words.size(), message, arguments);
    failIfGuarded(words.data());
    std::fprintf(stderr, "ODE: %s\n", words.data());
    std::abort();
}

} // namespace

OdeWorld::OdeWorld() {
    static std::once_flag started;
    std::call_once(started, [] {
        dInitODE2(0);
        if (dCheckConfiguration("ODE_double_precision") == 0) {
            throw std::runtime_error("ODE was built for single precision; Debian's counts in double");
        }
        dSetErrorHandler(failed);
        dSetDebugHandler(failed);
        // ODE reports singular systems and continues; its messages do not help players.
        dSetMessageHandler([](int, char const*, va_list) {});
    });
    world_ = dWorldCreate();
    threading_ = dThreadingAllocateSelfThreadedImplementation();
    dWorldSetStepThreadingImplementation(world_, dThreadingImplementationGetFunctions(threading_),
                                         threading_);
}

OdeWorld::~OdeWorld() {
    dWorldDestroy(world_);
    dThreadingFreeImplementation(threading_);
}

void OdeWorld::stepExactly(double h) {
    dWorldStep(world_, h);
}

void OdeWorld::stepQuickly(double h, int iterations) {
    // ODE shuffles rows with a random generator that all worlds of a process share.
    static std::mutex shuffling;
    std::lock_guard const lock(shuffling);
    dRandSetSeed(1);
    dWorldSetQuickStepNumIterations(world_, iterations);
    dWorldQuickStep(world_, h);
}

} // namespace trembler
#endif
