#include "physics/buoyancy/core/liquid_drag.hpp"

#include "physics/buoyancy/hulls/liquid_area.hpp"
#include "physics/depth.hpp"
#include "physics/dynamics/properties/shapes/mass_properties.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

// A rectangle's second moment along a side of length a is its area times a²/12.
double widthFrom(double moment, double area) {
    return std::sqrt(12 * std::max(moment, 0.0) / area);
}

} // namespace

double widthAcross(AreaMoments const& wet, Vec2 direction) {
    AreaMoments const own = wet.moved(-wet.centroid());
    Vec2 const n = perpendicular(direction);
    return widthFrom(own.xx * n.x * n.x + 2 * own.xy * n.x * n.y + own.yy * n.y * n.y, own.area);
}

double lengthOf(AreaMoments const& wet) {
    AreaMoments const own = wet.moved(-wet.centroid());
    double const mean = (own.xx + own.yy) / 2;
    double const half = std::hypot((own.xx - own.yy) / 2, own.xy);
    return widthFrom(mean + half, own.area);
}

namespace {

struct BodyMotion {
    Pose pose;
    Vec2 centreOfMass; // m, in the object's frame
    Vec2 velocity;
    double spin = 0;
    double mass = 0;    // kg; 0: unknown
    double inertia = 0; // kg m²

    [[nodiscard]] Vec2 velocityAt(Vec2 local) const {
        return velocity + spin * perpendicular(pose.turned(local - centreOfMass));
    }
};

LiquidResistance::Entry dragOn(Immersions::Entry const& immersion, Liquid const& liquid,
                               BodyMotion const& body) {
    AreaMoments const& wet = immersion.wet;
    Vec2 const centre = wet.centroid();
    Vec2 const through = body.velocityAt(centre) - liquid.current;
    double const speed = length(through);
    double const perArea = immersion.density * worldDepth;
    double rate = liquid.linearDrag * perArea * wet.area;
    if (speed > 0) {
        double const width = widthAcross(wet, body.pose.turnedBack(through / speed));
        rate += liquid.quadraticDrag * perArea / 2 * width * speed;
    }
    AreaMoments const own = wet.moved(-centre);
    double const reach = lengthOf(wet);
    double const turning =
        liquid.linearDrag * perArea * (own.xx + own.yy) +
        liquid.quadraticDrag * perArea / 2 * std::abs(body.spin) * reach * reach * reach * reach / 32;
    return {.object = immersion.object,
            .point = body.pose.toWorld(centre),
            .xx = rate,
            .xy = 0,
            .yy = rate,
            .angular = turning,
            .push = rate * liquid.current,
            .rate = 0, // drag is integrated implicitly, so it is stable at any rate
            .event = immersion.event};
}

struct Lag {
    double held = 0; // s, lag of F_B
    double turn = 0; // s, lag of the point where it acts
};

// A resistance to motion into and out of the surface at every point of the waterline, and to rotation as far
// as it changes the arm of F_B.
LiquidResistance::Entry lookAhead(Immersions::Entry const& immersion, BodyMotion const& body, double pull,
                                  Lag const& lag) {
    Waterline const& line = immersion.waterline;
    Vec2 const up = immersion.up;
    double const perArea = immersion.density * worldDepth * pull;
    double const middle = line.length > 0 ? line.first / line.length : 0;
    double const rate = lag.held * perArea * line.length;
    Vec2 const upward = body.pose.turnedBack(up);
    Vec2 const across{upward.y, -upward.x};
    double const above = dot(upward, immersion.wet.first - immersion.wet.area * body.centreOfMass);
    double const spread = std::max(0.0, line.second - line.first * middle);
    double const turning = lag.held * perArea * spread + lag.turn * perArea * above;
    double square = 0;
    if (body.mass > 0 && body.inertia > 0) {
        square = perArea * (line.length / body.mass + std::max(0.0, spread + above) / body.inertia);
    }
    return {.object = immersion.object,
            .point = body.pose.toWorld(middle * across),
            .xx = rate * up.x * up.x,
            .xy = rate * up.x * up.y,
            .yy = rate * up.y * up.y,
            .angular = std::max(0.0, turning), // below zero: an unstable body, which falls over anyway
            .push = {},
            .rate = std::sqrt(square),
            .event = immersion.event};
}

} // namespace

void LiquidDrag::update(Access& access) {
    Immersions const& immersions = access.read<Immersions>();
    auto const& liquids = access.read<Liquid>();
    auto const& shapes = access.read<Shape>();
    auto const& positions = access.read<Position>();
    auto const& rotations = access.read<Rotation>();
    auto const& velocities = access.read<Velocity>();
    auto const& spins = access.read<AngularVelocity>();
    auto const& masses = access.read<Mass>();
    auto const& settings = access.read<BuoyancySettings>();
    auto const& airs = access.read<Air>();
    Air const air = airs.empty() ? Air{} : airs.values().front();
    Liquid const asLiquid{air.linearDrag, air.quadraticDrag, air.wind};

    Vec2 const gravity = access.read<LinearGravityVector>().gravity;
    bool const ahead = settings.empty() || settings.values().front().lookAhead;
    ForceLag const& forceLag = access.read<ForceLag>();
    Lag const lag{ahead ? forceLag.of(std::max(immersions.interval, forceLag.turn)) : 0,
                  ahead ? forceLag.ofTurn() : 0};
    if (immersions.entries.empty() && access.derived<LiquidResistance>().entries.empty()) {
        return;
    }
    auto& entries = access.derive<LiquidResistance>().entries;
    entries.clear();
    access.derive<LiquidResistance>().foreseen = ahead;
    for (Immersions::Entry const& immersion : immersions.entries) {
        ObjectId const id = immersion.object;
        Liquid const* const liquid = immersion.liquid.valid() ? liquids.find(immersion.liquid) : &asLiquid;
        Shape const* const shape = shapes.find(id);
        Position const* const position = positions.find(id);
        Velocity const* const velocity = velocities.find(id);
        if (liquid == nullptr || shape == nullptr || position == nullptr || velocity == nullptr) {
            continue; // destroyed since the buoyancy was computed
        }
        Rotation const* const rotation = rotations.find(id);
        AngularVelocity const* const spin = spins.find(id);
        Mass const* const mass = masses.find(id);
        MassProperties const spread = massPropertiesOf(*shape);
        double const kilograms = mass == nullptr ? 0 : mass->value;
        BodyMotion const body{Pose(position->value, rotation == nullptr ? 0 : rotation->angle),
                              spread.centre,
                              velocity->value,
                              spin == nullptr ? 0 : spin->value,
                              kilograms,
                              kilograms * spread.inertiaPerMass};
        entries.push_back(dragOn(immersion, *liquid, body));
        entries.push_back(lookAhead(immersion, body, Immersions::pull(immersion, gravity), lag));
    }
}

} // namespace trembler
