#include "audio/synth/room.hpp"

#include "audio/effect/properties/acoustic_material.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/store.hpp"

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

constexpr int rays = 180;
constexpr double farthest = 25;   // m
constexpr double airLoss = 0.012; // 1/m

struct Hit {
    double distance = farthest;
    double absorption = 1; // no wall: all sound is lost
};

// The distance at which a ray enters a convex obstacle; beyond `farthest` if it does not. A ray from inside
// does not meet the obstacle: the listener is in front of the plane, so an obstacle behind it does not
// enclose it.
double entry(Obstacle const& obstacle, Vec2 from, Vec2 direction) {
    double enter = 0;
    double leave = farthest;
    std::size_t const n = obstacle.corners.size();
    bool outside = false;
    for (std::size_t i = 0; i < n; ++i) {
        Vec2 const corner = obstacle.corners[i];
        Vec2 const side = obstacle.corners[(i + 1) % n] - corner;
        double const inside = cross(side, from - corner);
        double const change = cross(side, direction);
        outside = outside || inside < 0;
        if (change == 0) {
            if (inside <= 0) {
                return 2 * farthest;
            }
        } else if (change > 0) {
            enter = std::max(enter, -inside / change);
        } else {
            leave = std::min(leave, -inside / change);
        }
    }
    return outside && leave > enter ? enter : 2 * farthest;
}

} // namespace

RoomAcoustics roomAround(std::span<Obstacle const> walls, std::map<ObjectId, Material> const& materials,
                         Vec2 point) {
    std::vector<Hit> hits(rays);
    for (int i = 0; i < rays; ++i) {
        Hit& hit = hits[static_cast<std::size_t>(i)];
        Vec2 const direction = rotated({1, 0}, 2 * pi * (i + 0.5) / rays);
        for (Obstacle const& wall : walls) {
            double const distance = entry(wall, point, direction);
            if (distance < hit.distance) {
                auto const material = materials.find(wall.object);
                hit.distance = distance;
                hit.absorption =
                    acousticMaterial(material == materials.end() ? Material::plastic : material->second)
                        .absorption;
            }
        }
    }
    // The polygon of the hits; each side takes half of its absorption from either end.
    RoomAcoustics room;
    double around = 0;
    double swallowed = 0;
    for (int i = 0; i < rays; ++i) {
        Hit const& a = hits[static_cast<std::size_t>(i)];
        Hit const& b = hits[static_cast<std::size_t>((i + 1) % rays)];
        double const angle = 2 * pi / rays;
        double const side = std::sqrt(std::max(0.0, a.distance * a.distance + b.distance * b.distance -
                                                        2 * a.distance * b.distance * std::cos(angle)));
        room.area += 0.5 * a.distance * b.distance * std::sin(angle);
        around += side;
        swallowed += side * 0.5 * (a.absorption + b.absorption);
    }
    double const depth = std::sqrt(room.area);
    room.volume = room.area * depth;
    room.surface = around * depth + 2 * room.area;
    room.absorption = swallowed / around; // front and back count like the walls
    double const absorbing = room.surface * room.absorption;
    room.reverberation = 0.161 * room.volume / (absorbing + airLoss * room.volume);
    room.echo = 16 * pi * (1 - room.absorption) / absorbing;
    return room;
}

RoomAcoustics roomAround(Store const& store, Vec2 point) {
    std::vector<Obstacle> walls;
    std::map<ObjectId, Material> materials;
    auto const* const fixed = store.findColumn<Fixed>();
    auto const* const shapes = store.findColumn<Shape>();
    auto const* const positions = store.findColumn<Position>();
    auto const* const rotations = store.findColumn<Rotation>();
    auto const* const madeOf = store.findColumn<MadeOf>();
    if (fixed == nullptr || shapes == nullptr || positions == nullptr) {
        return roomAround(walls, materials, point);
    }
    for (ObjectId const id : fixed->owners()) {
        Shape const* const shape = shapes->find(id);
        Position const* const position = positions->find(id);
        if (shape == nullptr || position == nullptr) {
            continue;
        }
        Rotation const* const rotation = rotations == nullptr ? nullptr : rotations->find(id);
        addObstacles(walls, id, *shape, position->value, rotation == nullptr ? 0 : rotation->angle, 0);
        if (MadeOf const* const of = madeOf == nullptr ? nullptr : madeOf->find(id)) {
            materials[id] = of->material;
        }
    }
    return roomAround(walls, materials, point);
}

} // namespace trembler
