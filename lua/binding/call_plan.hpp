// Calls whose arguments are all plain data: read without their description, and gathered until the end of a
// turn.
#pragma once

#include "runtime/component/role_info.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace trembler::lua {

/// An argument of a call, with all that is needed to read it.
struct PlainArgument {
    FieldKind kind = FieldKind::number; ///< boolean, number, vector or object
    std::size_t offset = 0;             ///< in the call's C++ type, in bytes
    double minimum = 0;
    double maximum = 0;
    bool minimumExcluded = false;

    /// Whether a number is in range. One that is not finite is not.
    [[nodiscard]] bool takes(double value) const {
        return (minimumExcluded ? value > minimum : value >= minimum) && value <= maximum;
    }
};

struct CallPlan {
    bool plain = false;   ///< all its arguments are PlainArguments
    bool creates = false; ///< it creates objects
    std::vector<PlainArgument> arguments;

    [[nodiscard]] bool hasVector() const {
        return std::any_of(arguments.begin(), arguments.end(),
                           [](PlainArgument const& each) { return each.kind == FieldKind::vector; });
    }
};

[[nodiscard]] CallPlan planOf(CallDescription const& call);

/// Calls of one kind that were made in this turn and are not recorded yet, as values of its C++ type.
/// Compiled code reads and writes it, so its layout is stated again in trusted_driver.cpp.
struct PendingCalls {
    char* bytes = nullptr;
    std::int32_t used = 0; ///< calls
    std::int32_t room = 0; ///< calls that `bytes` has room for
};
static_assert(sizeof(PendingCalls) == 16);

/// The pending calls of all kinds of a role.
class CallGatherer {
public:
    explicit CallGatherer(RoleInfo const& role);
    /// The place of the next call, filled with its initial values. The call counts once it is added.
    [[nodiscard]] char* place(std::size_t call);
    void add(std::size_t call) { ++pending_[call].used; }
    /// Records all pending calls, kind by kind.
    void record(OpenSource& source);
    void drop();
    /// Leaves no room, so that compiled code adds no call by itself but asks the host for each.
    void close();
    [[nodiscard]] PendingCalls* pending() { return pending_.data(); }

private:
    RoleInfo const& role_;
    std::vector<std::vector<char>> bytes_;
    std::vector<PendingCalls> pending_;
};

} // namespace trembler::lua
