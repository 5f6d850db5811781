#include "physics/buoyancy/core/flotation.hpp"

#include "physics/depth.hpp"
#include "physics/dynamics/properties/shapes/shape_order.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "runtime/property/for_each.hpp"

#include <algorithm>
#include <utility>

namespace trembler {
namespace {

constexpr double leastArea = 1e-12; // m²: a square of a thousandth of a millimetre
constexpr double margin = 1e-9;     // share of a coordinate: more than its rounding error
constexpr double leastDry = 1e-9;   // share of an immersed body's area: more than rounding leaves dry

double angleOf(FlotationColumns const& columns, ObjectId id) {
    Rotation const* const rotation = columns.rotation.find(id);
    return rotation == nullptr ? 0 : rotation->angle;
}

bool sameFloat(Immersions::Entry const& a, Immersions::Entry const& b) {
    return a.object == b.object && a.liquid == b.liquid;
}

bool before(Immersions::Entry const& a, Immersions::Entry const& b) {
    return a.object != b.object ? a.object < b.object : a.liquid < b.liquid;
}

} // namespace

bool Flotation::followLiquids(FlotationColumns const& columns, bool all) {
    bool changed = all;
    if (!all) {
        for (LiquidBody const& liquid : liquids_) {
            changed = changed || !(columns.position[liquid.object].value == liquid.position) ||
                      angleOf(columns, liquid.object) != liquid.angle;
        }
    }
    if (!changed) {
        return false;
    }
    liquids_.clear();
    std::vector<Bounds> areas;
    forEach(
        [&](ObjectId id, Liquid const&, Shape const& shape, Position const& position) {
            if (faultIn(shape)) {
                return;
            }
            Density const* const density = columns.density.find(id);
            LiquidBody liquid{.object = id,
                              .density = (density == nullptr ? Density{} : *density).value,
                              .position = position.value,
                              .angle = angleOf(columns, id),
                              .up = {},
                              .pieces = {}};
            Pose const pose(liquid.position, liquid.angle);
            liquid.up = pose.turned({0, 1});
            liquid.pieces = liquidPieces(inOrder(shape), pose);
            liquids_.push_back(std::move(liquid));
            areas.push_back(areaBounds(shape, pose));
        },
        columns.liquid, columns.shape, columns.position);
    areas_ = BoxTree(std::move(areas));
    return true;
}

void Flotation::followBodies(FlotationColumns const& columns, HullMaker const& makeHull) {
    bool const everywhere = columns.air.size() > 0;
    air_ = everywhere ? columns.air.values().front().density : Air{}.density;
    std::vector<Floater> earlier = std::exchange(floaters_, {});
    auto old = earlier.begin();
    forEach(
        [&](ObjectId id, Shape const& shape, Position const&) {
            // Fixed objects cannot be lifted, and an object with an invalid shape is no body in Dynamics
            // either.
            if (columns.liquid.has(id) || columns.fixed.has(id) || faultIn(shape)) {
                return;
            }
            for (; old != earlier.end() && old->object < id; ++old) {
            }
            bool const known = old != earlier.end() && old->object == id && old->shape == shape;
            Floater floater = known ? std::move(*old) : Floater{};
            if (!known) {
                floater.object = id;
                floater.shape = shape;
                floater.hull = makeHull(shape);
            }
            floater.inAir = everywhere || columns.inAir.has(id);
            SparedBy const* const spared = columns.sparedBy.find(id);
            floater.sparedBy = spared == nullptr ? SparedBy{} : *spared;
            floaters_.push_back(std::move(floater));
        },
        columns.shape, columns.position);
}

bool Flotation::follow(FlotationColumns const& columns, HullMaker const& makeHull,
                       ForRanges const& forRanges) {
    std::uint64_t const others = columns.liquid.version() + columns.density.version() +
                                 columns.fixed.version() + columns.air.version() + columns.inAir.version() +
                                 columns.sparedBy.version();
    std::uint64_t const places = columns.position.structureVersion() + columns.rotation.structureVersion();
    bool const all = !known_ || columns.shape.version() != shapes_ || others != others_ || places != places_;
    if (all) {
        followBodies(columns, makeHull);
        known_ = true;
        shapes_ = columns.shape.version();
        others_ = others;
        places_ = places;
    }
    bool const again = followLiquids(columns, all);
    std::vector<std::uint8_t> moved(floaters_.size(), 0);
    forRanges(floaters_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Floater& floater = floaters_[i];
            Vec2 const position = columns.position[floater.object].value;
            double const angle = angleOf(columns, floater.object);
            if (again || floater.fresh || !(position == floater.position) || angle != floater.angle) {
                floater.position = position;
                floater.angle = angle;
                floater.fresh = false;
                bool const wasDry = floater.entries.empty();
                measure(floater);
                moved[i] = wasDry && floater.entries.empty() ? 0 : 1;
            }
        }
    });
    return all || again || std::find(moved.begin(), moved.end(), 1) != moved.end();
}

void Flotation::measure(Floater& floater) const {
    Pose const pose(floater.position, floater.angle);
    floater.entries.clear();
    double const reach = floater.hull->radius() + margin * (1 + length(pose.at));
    std::vector<std::uint32_t> near;
    areas_.find({pose.at - Vec2{reach, reach}, pose.at + Vec2{reach, reach}}, near);
    AreaMoments dry = floater.hull->whole();
    for (std::uint32_t const index : near) {
        LiquidBody const& liquid = liquids_[index];
        if (floater.sparedBy.has(liquid.object)) {
            continue;
        }
        Displacement sum;
        for (LiquidPiece const& piece : liquid.pieces) {
            sum += displacedOf(*floater.hull, piece, pose, liquid.up);
        }
        dry += -1.0 * sum.wet;
        if (sum.wet.area > leastArea) {
            floater.entries.push_back({.object = floater.object,
                                       .liquid = liquid.object,
                                       .density = liquid.density,
                                       .up = liquid.up,
                                       .wet = sum.wet,
                                       .waterline = sum.waterline,
                                       .event = {}});
        }
    }
    // The rest of the body displaces air.
    if (floater.inAir && air_ > 0 && dry.area > std::max(leastArea, leastDry * floater.hull->whole().area)) {
        floater.entries.push_back({.object = floater.object,
                                   .liquid = {},
                                   .density = air_,
                                   .up = {}, // see gather()
                                   .wet = dry,
                                   .waterline = {},
                                   .event = {}});
    }
}

void Flotation::gather(std::vector<Immersions::Entry>& entries, Vec2 gravity) const {
    double const strength = length(gravity);
    Vec2 const up = strength > 0 ? -gravity / strength : Vec2{0, 1};
    entries.clear();
    for (Floater const& floater : floaters_) {
        entries.insert(entries.end(), floater.entries.begin(), floater.entries.end());
        if (!floater.entries.empty() && !floater.entries.back().liquid.valid()) {
            entries.back().up = up;
        }
    }
}

void matchEvents(std::vector<Immersions::Entry> const& earlier, std::vector<Immersions::Entry>& now,
                 std::function<EventId(Immersions::Entry const&)> const& enter,
                 std::function<void(Immersions::Entry const&)> const& leave) {
    auto old = earlier.begin();
    for (Immersions::Entry& entry : now) {
        for (; old != earlier.end() && before(*old, entry); ++old) {
            leave(*old);
        }
        if (old != earlier.end() && sameFloat(*old, entry)) {
            entry.event = old->event;
            ++old;
        } else {
            entry.event = enter(entry);
        }
    }
    for (; old != earlier.end(); ++old) {
        leave(*old);
    }
}

void sumForces(std::vector<Immersions::Entry> const& entries, Vec2 gravity,
               std::function<Pose(ObjectId)> const& pose, BuoyancyForce& forces, CentreOfBuoyancy& centres) {
    forces.forces.clear();
    centres.centres.clear();
    for (std::size_t i = 0; i < entries.size();) {
        ObjectId const object = entries[i].object;
        Vec2 sum;
        Vec2 moment; // of the forces' strengths
        double strengths = 0;
        double torque = 0; // N m, about the object's origin
        double most = -1;
        EventId event;
        for (; i < entries.size() && entries[i].object == object; ++i) {
            Immersions::Entry const& entry = entries[i];
            double const strength =
                entry.density * entry.wet.area * worldDepth * Immersions::pull(entry, gravity);
            Vec2 const centre = entry.wet.centroid();
            sum += strength * entry.up;
            moment += strength * centre;
            strengths += strength;
            torque += cross(pose(object).turned(centre), strength * entry.up);
            if (strength > most) {
                most = strength;
                event = entry.event;
            }
        }
        Pose const where = pose(object);
        // Without any force the centre is that of the last liquid's share.
        Vec2 centre = strengths > 0 ? moment / strengths : entries[i - 1].wet.centroid();
        if (double const square = lengthSquared(sum); square > 0) {
            // Moves the centre to where forces that are not parallel meet; for parallel forces this changes
            // only rounding.
            double const missing = torque - cross(where.turned(centre), sum);
            centre += where.turnedBack(missing / square * Vec2{sum.y, -sum.x});
        }
        forces.forces.push_back({object, sum, event});
        centres.centres.push_back({object, centre, where.toWorld(centre)});
    }
}

} // namespace trembler
