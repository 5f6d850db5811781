// The resolver that creates and destroys objects.
#pragma once

#include "runtime/component/interaction.hpp"
#include "runtime/component/resolver.hpp"
#include "runtime/input/input_resolver.hpp"
#include "runtime/population/calls.hpp"
#include "runtime/property/news.hpp"

namespace trembler {

/// Which objects were created and which were destroyed in this frame, or this part of it.
struct PopulationChanges {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{
        "Population changes", "population_changes",
        "The objects that were created or destroyed in this frame, or this part of it."};
    static constexpr Coverage coverage = hashed;
    std::vector<ObjectId> created;
    std::vector<ObjectId> destroyed; ///< these ids are stale

    static void gather(PopulationChanges& frame, PopulationChanges const& part, PartSpan) {
        frame.created.insert(frame.created.end(), part.created.begin(), part.created.end());
        frame.destroyed.insert(frame.destroyed.end(), part.destroyed.begin(), part.destroyed.end());
    }
};

/// Writes every property, as an object gets all its properties when it is created and loses them when it is
/// destroyed. So all other resolvers run after it.
class PopulationResolver final
    : public Resolver<PopulationResolver, PopulationRole, Reads<>, Writes<>, Provides<PopulationChanges>> {
public:
    static constexpr ComponentText text{
        .name = "Population",
        .effect = "population",
        .level = "",
        .work = "Destroys and creates objects as requested. Ids follow from the keys of the calls, so they "
                "do not depend on the order of calls or on threads."};
    static constexpr bool writesEverything = true;
    using Activation = NeedsAll<>;
    static constexpr Coverage memory =
        leftOut("whether Population changes has news to clear, which follows from it");

    void bindStore(Store& store) { store_ = &store; }
    [[nodiscard]] bool restless() const { return changesStand_; }
    void advance(Access& access);

private:
    struct Birth {
        CreateObject call;
        EventId cause;
        std::string maker; // its name
    };
    /// Creates the object with the properties that its birth states, not yet completed; an invalid id if no
    /// object is made.
    [[nodiscard]] ObjectId create(Birth const& birth);

    Store* store_ = nullptr;
    bool changesStand_ = false;
};

/// Destroys the objects that the player removed.
class PopulationFromPlayer final
    : public Interaction<PopulationFromPlayer, PopulationRole, Reads<PlayerCommands>> {
public:
    static constexpr ComponentText text{.name = "Population <- Player",
                                        .effect = "population",
                                        .level = "",
                                        .work = "Destroys every object that the player removed."};
    using Activation = NeedsAll<>;
    void apply(Access& access);
};

class Registry;
/// Properties of placement, the player's input and the population: the parts of a world without physics.
void registerRuntime(Registry& registry);

} // namespace trembler
