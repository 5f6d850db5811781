// Replaces Dynamics in worlds in which forces are examined and no object moves: tests and measurements.
#pragma once

#include "physics/dynamics/properties/force_lag.hpp"
#include "runtime/component/resolver.hpp"

namespace trembler {

struct StandstillRole {
    static constexpr std::string_view name = "Standstill";
    using Calls = CallList<>;
};

/// Forces have no lag. Not part of the program: register it in place of Dynamics.
class Standstill final : public Resolver<Standstill, StandstillRole, Reads<>, Writes<>, Provides<ForceLag>> {
public:
    static constexpr ComponentText text{
        .name = "Standstill", .effect = "dynamics", .level = "", .work = "Moves nothing."};
    using Activation = NeedsAll<>;
    void advance(Access&) {}
};

} // namespace trembler
