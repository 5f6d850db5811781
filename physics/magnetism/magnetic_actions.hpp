// Which magnet begins or ceases to act on which object: events for traces.
#pragma once

#include "physics/magnetism/magnetic_effects.hpp"

#include <functional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace trembler {

/// Records an event and returns it, as Access::event does.
using RecordEvent = std::function<EventId(std::string_view what, std::span<ObjectId const> objects,
                                          std::span<EventId const> causes)>;

/// The words of the events. The objects are the one that is moved and the one that acts on it.
namespace magnetic_events {
inline constexpr std::string_view attracted = "attracted";
inline constexpr std::string_view repelled = "repelled";
inline constexpr std::string_view noLongerAttracted = "no longer attracted";
inline constexpr std::string_view noLongerRepelled = "no longer repelled";
} // namespace magnetic_events

/// Without a switched magnet, actions are followed in every fourth update at most: objects approach each
/// other slowly compared to that.
inline constexpr int followPeriod = 4;

/// Actions are not followed again before a pole or a centre of susceptible matter has moved by this much, in
/// m.
inline constexpr double followDistance = magneticSoftening / 10;

/// At most so many actions on one object are followed at a time: the strongest.
inline constexpr std::size_t mostActions = 16;

/// Follows what each magnet does to each object that can move, and each such object to a magnet.
class MagneticActions {
public:
    /// Brings `into.actions` up to date, which has the actions that were followed last, and records an event
    /// for each one that begins or ends.
    ///
    /// An action begins when its force exceeds `negligibleForce` and ends below half of it. Of more than
    /// `mostActions` on an object the weakest are left out; one that is followed stays until another one is
    /// twice as strong. If attraction turns to repulsion, another action begins in place of the first. The
    /// action of a magnet with several poles is a pull if the sum of its forces is directed towards its
    /// nearest poles.
    ///
    /// The cause of a beginning is the switching on of either magnet, that of an end the switching off, if
    /// either is an electromagnet; otherwise there is none, as they are then known to have only come near
    /// each other. `switching` are the events by object index. Objects that cannot move are left out, as
    /// nothing follows from the forces on them. For each object only those near enough to act on it are
    /// looked at, but in a crowd these are all: O(n²) for n objects, so only while tracing.
    void follow(MagneticPoints const& points, MagneticColumns const& columns,
                std::span<EventId const> switching, RecordEvent const& record, MagneticForce& into);

    /// Whether anything has moved by more than `followDistance`, or acts more or less strongly, since the
    /// last call of follow().
    [[nodiscard]] bool outdated(MagneticPoints const& points) const;

    /// Sets the causes of `into.forces`: the event of the strongest of the actions on their object.
    void nameCauses(MagneticForce& into) const;

private:
    magnetic_actions::Surroundings surroundings_;
    inverse_square::Points poles_; // when actions were followed last
    inverse_square::Points soft_;
    std::vector<std::pair<ObjectId, EventId>> strongest_; // of the actions on each object, ascending
    std::vector<MagneticForce::Action> before_;           // those followed last, during an update
};

} // namespace trembler
