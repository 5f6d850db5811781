#include "audio/effect/interactions/from_dynamics.hpp"

#include "audio/effect/core/contact_pulse.hpp"
#include "audio/effect/core/rubbing.hpp"
#include "audio/effect/properties/acoustic_material.hpp"
#include "physics/dynamics/properties/shapes/mass_properties.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

template <class Access>
class Scene {
public:
    explicit Scene(Access const& access) : access_(access) {}

    template <class P>
    [[nodiscard]] P const* find(ObjectId id) const {
        return access_.template read<P>().find(id);
    }
    [[nodiscard]] bool sounds(ObjectId id) const {
        return find<MadeOf>(id) != nullptr || find<Acoustics>(id) != nullptr;
    }
    [[nodiscard]] Material material(ObjectId id) const {
        MadeOf const* const of = find<MadeOf>(id);
        return of == nullptr ? Material::plastic : of->material;
    }
    [[nodiscard]] bool movable(ObjectId id) const {
        return find<Mass>(id) != nullptr && !access_.template read<Fixed>().has(id);
    }
    [[nodiscard]] double roundness(ObjectId id) const {
        Shape const* const shape = find<Shape>(id);
        return shape == nullptr ? 0 : roundnessOf(*shape);
    }
    [[nodiscard]] double angle(ObjectId id) const {
        Rotation const* const rotation = find<Rotation>(id);
        return rotation == nullptr ? 0 : rotation->angle;
    }
    [[nodiscard]] Vec2 position(ObjectId id) const {
        Position const* const position = find<Position>(id);
        return position == nullptr ? Vec2{} : position->value;
    }
    [[nodiscard]] double spin(ObjectId id) const {
        AngularVelocity const* const spin = find<AngularVelocity>(id);
        return spin == nullptr ? 0 : spin->value;
    }
    /// The velocity of the object's matter at a point of the world, in m/s.
    [[nodiscard]] Vec2 velocityAt(ObjectId id, Vec2 point) const {
        Velocity const* const velocity = find<Velocity>(id);
        Shape const* const shape = find<Shape>(id);
        if (velocity == nullptr || shape == nullptr) {
            return {};
        }
        Vec2 const centre = position(id) + rotated(centreOfMass(*shape), angle(id));
        return velocity->value + spin(id) * perpendicular(point - centre);
    }
    [[nodiscard]] Vec2 toLocal(ObjectId id, Vec2 point) const {
        return rotated(point - position(id), -angle(id));
    }
    [[nodiscard]] Vec2 directionToLocal(ObjectId id, Vec2 direction) const {
        return rotated(direction, -angle(id));
    }

private:
    Access const& access_;
};

// The event with which the two began to touch.
EventId touchOf(Contacts const& contacts, ObjectId a, ObjectId b) {
    TouchingPair const pair{a, b, {}};
    for (auto const* list : {&contacts.begun, &contacts.current, &contacts.brief}) {
        auto const at = std::lower_bound(list->begin(), list->end(), pair);
        if (at != list->end() && *at == pair) {
            return at->event;
        }
    }
    return {};
}

} // namespace

void SoundFromDynamics::apply(Access& access) {
    callStrikes(access);
    callRubs(access);
}

void SoundFromDynamics::callStrikes(Access& access) {
    Scene const scene(access);
    Contacts const& contacts = access.read<Contacts>();
    for (Impact const& impact : access.read<Impacts>().impacts) {
        if (!(scene.movable(impact.a) || scene.movable(impact.b)) || !(impact.impulse > 0)) {
            continue;
        }
        EventId const cause = access.tracing() ? touchOf(contacts, impact.a, impact.b) : EventId{};
        auto const call = [&](ObjectId object, ObjectId other, Vec2 direction) {
            if (scene.sounds(object)) {
                access.call(Strike{object, other, scene.toLocal(object, impact.point),
                                   scene.directionToLocal(object, direction), impact.impulse, 0,
                                   impact.since},
                            cause);
            }
            Sample const* const sample = scene.template find<Sample>(object);
            if (sample != nullptr && sample->cue == SampleCue::struck) {
                double const share = std::min(1.0, impact.impulse / sample->fullImpulse);
                access.call(PlaySample{object, share * share}, cause);
            }
        };
        call(impact.a, impact.b, -impact.normal);
        call(impact.b, impact.a, impact.normal);
    }
}

void SoundFromDynamics::callRubs(Access& access) {
    Scene const scene(access);
    double const step = access.read<ContactPatches>().step;
    if (!(step > 0)) {
        return; // no object has ever moved
    }
    auto const friction = [&](ObjectId id) {
        Friction const* const stated = scene.template find<Friction>(id);
        return stated == nullptr ? Friction{}.coefficient : stated->coefficient;
    };
    for (ContactPatch const& patch : access.read<ContactPatches>().patches) {
        double const load = (patch.normalImpulse[0] + (patch.count > 1 ? patch.normalImpulse[1] : 0)) / step;
        if (!(load > faintestRubbing)) {
            continue;
        }
        Vec2 const point = patch.count > 1 ? 0.5 * (patch.points[0] + patch.points[1]) : patch.points[0];
        Vec2 const relative = scene.velocityAt(patch.b, point) - scene.velocityAt(patch.a, point);
        double const slip = std::abs(dot(relative, perpendicular(patch.normal)));
        double const turning = std::abs(scene.spin(patch.b) - scene.spin(patch.a));
        double const rolling = turning * std::max(scene.roundness(patch.a), scene.roundness(patch.b));
        double const speed = rubbingSpeed(slip, rolling);
        if (!(speed > 0)) {
            continue;
        }
        double const force = rubbingForce(load, slip, std::sqrt(friction(patch.a) * friction(patch.b)));
        double const bump = std::max(acousticMaterial(scene.material(patch.a)).roughness,
                                     acousticMaterial(scene.material(patch.b)).roughness);
        if (!(force > faintestRubbing)) {
            continue;
        }
        EventId const cause =
            access.tracing() ? touchOf(access.read<Contacts>(), patch.a, patch.b) : EventId{};
        auto const call = [&](ObjectId object, ObjectId other, Vec2 direction) {
            if (scene.sounds(object)) {
                access.call(Rub{object, other, scene.toLocal(object, point),
                                scene.directionToLocal(object, direction), force, speed / bump},
                            cause);
            }
        };
        call(patch.a, patch.b, -patch.normal);
        call(patch.b, patch.a, patch.normal);
    }
}

} // namespace trembler
