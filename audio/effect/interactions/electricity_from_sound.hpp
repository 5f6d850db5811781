// (Electricity <- Sound): a sound sensor conducts while it hears enough.
#pragma once

#include "audio/effect/properties/acoustics.hpp"
#include "audio/effect/properties/loudness.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/electricity/calls.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/graph.hpp"
#include "runtime/component/interaction.hpp"

namespace trembler {

/// It compares the required connections with the connections that it has made, as (Electricity <- Dynamics)
/// does. It belongs to sound, and not to electricity, as physics must build and run without sound.
class ElectricityFromSound final
    : public Interaction<ElectricityFromSound, ElectricityRole,
                         Reads<Loudness, SoundSensor, Contacts, Conductor, ElectricityGraph>> {
public:
    static constexpr ComponentText text{
        .name = "Electricity <- Sound",
        .effect = "sound",
        .level = "",
        .work = "While the sound at a sensor is loud enough, connects the two conductors that it names, or "
                "all conductors that touch it; disconnects them afterwards."};
    using Activation = NeedsAll<SoundSensor>;
    /// The connections that it has made and will remove.
    void hashMemory(StateHash& hash) const { hash.members(connected_); }
    void apply(Access& access);

private:
    struct Link {
        ObjectId sensor;
        ObjectId a; ///< a < b
        ObjectId b;
        friend auto operator<=>(Link const&, Link const&) = default;
    };
    [[nodiscard]] static std::vector<Link> possible(Access& access);
    static void recall(Access& access, std::vector<Link> const& possible, std::vector<Link>& connected);

    std::vector<Link> connected_; // ascending
};

} // namespace trembler
