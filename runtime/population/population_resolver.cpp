#include "runtime/population/population_resolver.hpp"

#include "runtime/frame/frame_resolver.hpp"
#include "runtime/placement.hpp"
#include "runtime/population/birth_name.hpp"
#include "runtime/world/registry.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace trembler {

void PopulationResolver::advance(Access& access) {
    if (changesStand_) {
        access.provide<PopulationChanges>() = {};
        changesStand_ = false;
    }
    std::vector<std::pair<ObjectId, EventId>> deaths;
    access.forCalls<DestroyObject>([&](DestroyObject const& call, CallOrigin origin) {
        if (store_->alive(call.object)) {
            deaths.emplace_back(call.object, origin.cause);
        }
    });
    std::vector<Birth> births;
    access.forCalls<CreateObject>([&](CreateObject const& call, CallOrigin origin) {
        // The maker's name is looked up now, as the maker may be destroyed in this frame.
        births.push_back({call, origin.cause, store_->nameOf(call.maker)});
    });
    if (deaths.empty() && births.empty()) {
        return;
    }
    changesStand_ = true;
    std::sort(deaths.begin(), deaths.end());
    std::vector<ObjectId> destroyed;
    for (std::size_t i = 0; i < deaths.size();) {
        ObjectId const object = deaths[i].first;
        std::vector<EventId> causes;
        for (; i < deaths.size() && deaths[i].first == object; ++i) {
            causes.push_back(deaths[i].second);
        }
        access.event("destroyed", std::array{object}, causes);
        destroyed.push_back(object);
    }
    store_->destroy(destroyed);
    access.provide<PopulationChanges>().destroyed = std::move(destroyed);

    std::stable_sort(births.begin(), births.end(),
                     [](Birth const& a, Birth const& b) { return a.call.key() < b.call.key(); });
    births.erase(std::unique(births.begin(), births.end(),
                             [](Birth const& a, Birth const& b) { return a.call.key() == b.call.key(); }),
                 births.end());
    std::vector<ObjectId> created;
    std::vector<EventId> causes;
    for (Birth const& birth : births) {
        if (ObjectId const id = create(birth); id.valid()) {
            created.push_back(id);
            causes.push_back(birth.cause);
        }
    }
    store_->complete(created);
    for (std::size_t i = 0; i < created.size(); ++i) {
        access.event("created", {created[i]}, {causes[i]});
    }
    access.provide<PopulationChanges>().created = std::move(created);
}

ObjectId PopulationResolver::create(Birth const& birth) {
    CreateObject const& call = birth.call;
    Prototype const* const prototype = store_->prototypes().find(call.prototype);
    if (prototype == nullptr || prototype->composite || !isFinite(call.position) ||
        !std::isfinite(call.angle) || !isFinite(call.velocity) || !std::isfinite(call.spin)) {
        return {};
    }
    std::string name = birthName(prototype->name, birth.maker, call.number);
    for (std::uint64_t attempt = 2; store_->find(name).valid(); ++attempt) {
        name = birthName(prototype->name, birth.maker, call.number, attempt);
    }
    ObjectId const id = store_->create(name, {.kind = Origin::Kind::birth,
                                              .prototype = call.prototype,
                                              .number = call.number,
                                              .maker = call.maker});
    store_->furnish(id, *prototype);
    store_->column<Position>().set(id, {call.position});
    store_->column<Rotation>().set(id, {call.angle});
    store_->column<Velocity>().set(id, {call.velocity});
    store_->column<AngularVelocity>().set(id, {call.spin});
    return id;
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
    registry.property<FrameSettings>();
    registry.component<PopulationResolver>();
    registry.component<InputResolver>();
    registry.component<PopulationFromPlayer>();
    registry.component<FrameResolver>();
}

} // namespace trembler
