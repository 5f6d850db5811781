// The part of Buoyancy that depends neither on the detail level nor on how a resolver accesses its
// properties.
#pragma once

#include "physics/box_tree.hpp"
#include "physics/buoyancy/hulls/hull.hpp"
#include "physics/buoyancy/properties/air.hpp"
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/buoyancy/properties/results.hpp"
#include "physics/buoyancy/properties/spared_by.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "runtime/placement.hpp"
#include "runtime/property/column.hpp"

#include <functional>

namespace trembler {

struct FlotationColumns {
    Column<Position> const& position;
    Column<Rotation> const& rotation;
    Column<Shape> const& shape;
    Column<Density> const& density;
    Column<Liquid> const& liquid;
    Column<Air> const& air;
    Column<InAir> const& inAir;
    Column<Fixed> const& fixed;
    Column<SparedBy> const& sparedBy;
};

/// Stores, for every body, the area of every liquid that it displaces; computes it again only for bodies that
/// have moved.
class Flotation {
public:
    using HullMaker = std::function<std::unique_ptr<Hull>(Shape const&)>;
    /// Calls f(begin, end) for ranges that cover [0, count), perhaps at the same time.
    using ForRanges = std::function<void(std::size_t, std::function<void(std::size_t, std::size_t)> const&)>;

    /// Discards all hulls when they must be made in another way.
    void forgetHulls() {
        floaters_.clear();
        known_ = false;
    }
    /// Reads the present bodies and liquids. Returns whether any result may have changed since the last call.
    bool follow(FlotationColumns const& columns, HullMaker const& makeHull, ForRanges const& forRanges);
    /// The displaced areas, in order; without events. `gravity` (m/s²) determines which way is up in the air.
    void gather(std::vector<Immersions::Entry>& entries, Vec2 gravity) const;

private:
    struct LiquidBody {
        ObjectId object;
        double density = 0;
        Vec2 position;
        double angle = 0;
        Vec2 up; // out of its surface
        std::vector<LiquidPiece> pieces;
    };
    struct Floater {
        ObjectId object;
        Shape shape; // of which the hull was made
        std::unique_ptr<Hull> hull;
        Vec2 position;
        double angle = 0;
        bool fresh = true; // has not been measured yet
        bool inAir = false;
        SparedBy sparedBy;
        std::vector<Immersions::Entry> entries;
    };
    bool followLiquids(FlotationColumns const& columns, bool all);
    void followBodies(FlotationColumns const& columns, HullMaker const& makeHull);
    void measure(Floater& floater) const;

    std::vector<LiquidBody> liquids_; // ascending
    BoxTree areas_;                   // of the liquids
    double air_ = 0;                  // kg/m³
    std::vector<Floater> floaters_;   // ascending
    bool known_ = false;
    std::uint64_t shapes_ = 0;
    std::uint64_t others_ = 0;
    std::uint64_t places_ = 0;
};

/// Copies the events of entries that exist in `before`, and records new events: `enter(entry)` and
/// `leave(entry)` for each object that entered or left a liquid. Both lists are ascending.
void matchEvents(std::vector<Immersions::Entry> const& before, std::vector<Immersions::Entry>& now,
                 std::function<EventId(Immersions::Entry const&)> const& enter,
                 std::function<void(Immersions::Entry const&)> const& leave);

/// Forces and their centres from the displaced areas. `pose` gives an object's pose.
void sumForces(std::vector<Immersions::Entry> const& entries, Vec2 gravity,
               std::function<Pose(ObjectId)> const& pose, BuoyancyForce& forces, CentreOfBuoyancy& centres);

} // namespace trembler
