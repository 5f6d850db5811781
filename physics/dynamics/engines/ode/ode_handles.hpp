// RAII owners of ODE's objects.
#pragma once

#include <memory>
#include <ode/ode.h>
#include <type_traits>

namespace trembler {

template <auto Free>
struct OdeFree {
    template <class T>
    void operator()(T* handle) const {
        Free(handle);
    }
};

using OdeBody = std::unique_ptr<std::remove_pointer_t<dBodyID>, OdeFree<dBodyDestroy>>;
using OdeJoint = std::unique_ptr<std::remove_pointer_t<dJointID>, OdeFree<dJointDestroy>>;
using OdeJointGroup = std::unique_ptr<std::remove_pointer_t<dJointGroupID>, OdeFree<dJointGroupDestroy>>;

/// A world that computes on the thread that steps it, and shares no state with other worlds.
class OdeWorld {
public:
    OdeWorld();
    ~OdeWorld();
    OdeWorld(OdeWorld const&) = delete;
    OdeWorld& operator=(OdeWorld const&) = delete;

    [[nodiscard]] dWorldID get() const { return world_; }
    /// Solves all rows exactly (O(rows³) for each island), in a step of `h` (s).
    void stepExactly(double h);
    /// Solves them by successive over-relaxation, in an order that is the same in every run.
    void stepQuickly(double h, int iterations);

private:
    dWorldID world_;
    dThreadingImplementationID threading_;
};

} // namespace trembler
