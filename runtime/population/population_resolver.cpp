#include "runtime/population/population_resolver.hpp"

#include "runtime/placement.hpp"
#include "runtime/world/registry.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace trembler {

void PopulationResolver::advance(Access& access) {
    if (changesStand_) {
        access.provide<PopulationChanges>() = {};
        changesStand_ = false;
    }
    std::vector<ObjectId> destroyed;
    access.forCalls<DestroyObject>([&](DestroyObject const& call, CallOrigin origin) {
        bool const known = std::find(destroyed.begin(), destroyed.end(), call.object) != destroyed.end();
        if (store_->alive(call.object) && !known) {
            access.event("destroyed", {call.object}, {origin.cause});
            destroyed.push_back(call.object);
        }
    });
    struct Birth {
        CreateObject call;
        EventId cause;
    };
    std::vector<Birth> births;
    access.forCalls<CreateObject>(
        [&](CreateObject const& call, CallOrigin origin) { births.push_back({call, origin.cause}); });
    if (destroyed.empty() && births.empty()) {
        return;
    }
    changesStand_ = true;
    std::sort(destroyed.begin(), destroyed.end());
    store_->destroy(destroyed);
    access.provide<PopulationChanges>().destroyed = std::move(destroyed);

    std::stable_sort(births.begin(), births.end(),
                     [](Birth const& a, Birth const& b) { return a.call.key() < b.call.key(); });
    births.erase(std::unique(births.begin(), births.end(),
                             [](Birth const& a, Birth const& b) { return a.call.key() == b.call.key(); }),
                 births.end());
    for (Birth const& birth : births) {
        create(access, birth.call, birth.cause);
    }
}

void PopulationResolver::create(Access& access, CreateObject const& call, EventId cause) {
    Prototype const* const prototype = store_->prototypes().find(call.prototype);
    if (prototype == nullptr || !isFinite(call.position) || !isFinite(call.velocity)) {
        return;
    }
    std::string const stem = fmt::format("{} of {}", prototype->name, store_->nameOf(call.maker));
    std::string name = fmt::format("{} {}", stem, call.number);
    for (int again = 2; store_->find(name).valid(); ++again) {
        name = fmt::format("{} {} ({})", stem, call.number, again);
    }
    ObjectId const id = store_->create(name);
    store_->furnish(id, *prototype);
    store_->column<Position>().set(id, {call.position});
    store_->column<Rotation>().set(id, {call.angle});
    store_->column<Velocity>().set(id, {call.velocity});
    store_->column<AngularVelocity>().set(id, {call.spin});
    store_->complete(id);
    access.event("created", {id}, {cause});
    access.provide<PopulationChanges>().created.push_back(id);
}

void PopulationFromPlayer::apply(Access& access) {
    for (auto const& removal : access.read<PlayerCommands>().removals) {
        access.call(DestroyObject{removal.object}, removal.event);
    }
}

void registerRuntime(Registry& registry) {
    registry.property<Name>();
    registry.property<Position>();
    registry.property<Rotation>();
    registry.property<Velocity>();
    registry.property<AngularVelocity>();
    registry.component<PopulationResolver>();
    registry.component<InputResolver>();
    registry.component<PopulationFromPlayer>();
}

} // namespace trembler
