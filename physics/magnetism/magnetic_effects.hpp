// What objects do to each other by magnetism, pair by pair.
#pragma once

#include "physics/box_tree.hpp"
#include "physics/dynamics/calls.hpp"
#include "physics/magnetism/magnetic_points.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace trembler::magnetic_actions {

/// An action that is followed ends below this force, in N.
inline constexpr double endForce = negligibleForce / 2;

/// What one object does to another one: the force, and its part that is directed towards the acting object.
struct Effect {
    ObjectId by;
    double force = 0; ///< N
    double along = 0; ///< N, negative: away
};

/// The points of an object: its poles, and its centre of mass if it is susceptible.
struct Thing {
    ObjectId object;
    PointRange poles; ///< as MagneticPoints::forObjects() states them
    PointRange soft;
    Bounds bounds;                               ///< m, of its points
    double poleStrength = 0, susceptibility = 0; ///< A m, sums

    /// No force of the other thing on this one at a distance of r (m) exceeds this number divided by r².
    [[nodiscard]] double mostForce(double otherPoles, double otherSusceptibility) const;
};

/// Finds the things near enough to act on one. Keeps its memory from one update to the next.
class Surroundings {
public:
    /// Takes the objects from points, which must stay until the last search.
    void update(MagneticPoints const& points);

    /// All objects with points, ascending.
    [[nodiscard]] std::span<Thing const> things() const { return things_; }

    /// All effects on a thing of at least `endForce`, and some smaller ones; ascending by object. Valid until
    /// the next search.
    [[nodiscard]] std::vector<Effect>& effectsOn(Thing const& on);

private:
    MagneticPoints const* points_ = nullptr;
    std::vector<Thing> things_;
    std::optional<BoxTree> tree_;     // of the things' bounds; none if these are few
    std::vector<std::uint32_t> near_; // of things_, of one search; all of them without a tree
    std::vector<Effect> effects_;     // of one search
    double strongest_ = 0;            // A m
    double softest_ = 0;              // A m
};

} // namespace trembler::magnetic_actions
