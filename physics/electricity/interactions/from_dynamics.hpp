// (Electricity <- Dynamics): conductors that touch are connected.
#pragma once

#include "physics/dynamics/properties/contacts.hpp"
#include "physics/electricity/calls.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/graph.hpp"
#include "runtime/component/interaction.hpp"

#include <vector>

namespace trembler {

/// Connects conductors that begin to touch and disconnects conductors that cease to touch.
///
/// It does not add up C_N and C_P, but compares C_C with the connections that it has made. So each contact is
/// counted once and removed once, even if it misses a frame (a period), is applied for another reason than a
/// change of contacts, or is constructed while objects touch already. For this it reads G_E, too.
class ElectricityFromDynamics final : public Interaction<ElectricityFromDynamics, ElectricityRole,
                                                         Reads<Contacts, Conductor, ElectricityGraph>> {
public:
    static constexpr ComponentText text{.name = "Electricity <- Dynamics",
                                        .effect = "electricity",
                                        .level = "",
                                        .work =
                                            "Connects any new colliding objects (if both are conductors) and "
                                            "disconnects any previous colliding objects."};
    using Activation = NeedsAll<Conductor>;
    /// The connections that it has made and will remove.
    void hashMemory(StateHash& hash) const { hash.members(connected_); }
    void apply(Access& access);

private:
    std::vector<TouchingPair> connected_; // ascending
    std::vector<TouchingPair> touching_;
};

} // namespace trembler
