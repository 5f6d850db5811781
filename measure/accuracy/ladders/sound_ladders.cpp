// Sound ladder: the number of modes per body, against all modes.
#include "audio/effect/properties/sounds.hpp"
#include "measure/accuracy/ladder.hpp"
#include "measure/accuracy/ladders/effect_clock.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/material.hpp"
#include "puzzle/data/game_data.hpp"
#include "runtime/placement.hpp"
#include "runtime/world/world.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>

namespace trembler::accuracy {
namespace {

struct Hearing {
    double microseconds = 0;
    std::map<std::pair<int, ObjectId>, double> brightness; ///< Hz, by frame and body
};

// Bars, plates and balls of five materials fall on a stone floor.
Hearing listen(GameData const& gameData, std::string const& level, int bodies, int frames) {
    World world(gameData.registry, {.threads = 1, .detail = {{"sound", level}}, .periods = {}});
    Store& store = world.store();
    store.column<GravityField>().set(store.create("world"), {{0, -earthGravity}});
    auto const put = [&](std::string const& name, ShapePiece piece, Vec2 at, double angle,
                         Material material) {
        ObjectId const id = store.create(name);
        store.column<Shape>().set(id, {{std::move(piece)}});
        store.column<Position>().set(id, {at});
        store.column<Rotation>().set(id, {angle});
        store.column<MadeOf>().set(id, {material});
        return id;
    };
    ObjectId const floor = put("floor", boxPiece(100, 1), {0, -0.5}, 0, Material::stone);
    store.column<Fixed>().set(floor, {});
    constexpr std::array<Material, 5> materials{Material::steel, Material::wood, Material::glass,
                                                Material::copper, Material::stone};
    for (int i = 0; i < bodies; ++i) {
        ShapePiece const piece = i % 3 == 0   ? boxPiece(0.4, 0.06)
                                 : i % 3 == 1 ? boxPiece(0.25, 0.2)
                                              : circlePiece(0.1);
        put(fmt::format("body {:02}", i), piece, {1.0 * i - bodies / 2.0, 0.4 + 0.1 * (i % 4)}, 0.3 * i,
            materials[static_cast<std::size_t>(i) % materials.size()]);
    }
    Subscription const wantedSounds = world.want<Sounds>();
    world.start();
    EffectClock clock("sound");
    Hearing found;
    for (int frame = 0; frame < frames; ++frame) {
        world.step();
        clock.frame(world);
        Sounds const* const sounds = world.find<Sounds>();
        for (Sounds::Body const& body : sounds->bodies) {
            if (!body.rings.empty() && body.loudness > 0) {
                found.brightness[{frame, body.object}] = body.brightness;
            }
        }
    }
    found.microseconds = clock.mean();
    return found;
}

Ladder climbModes(GameData const& gameData, Effort effort) {
    // Enough sounding bodies for the cost of the modes to exceed the constant cost of impacts.
    int const bodies = effort.brief ? 3 : 60;
    int const frames = effort.brief ? 40 : 180;
    Ladder ladder{"",         fmt::format("{} bodies fall on stone", bodies),
                  "Hz",       "mean difference of the mean audible frequency of a body",
                  "32 modes", true,
                  {},         {}};
    Hearing const right = listen(gameData, "32-modes", bodies, frames);
    for (std::string const level : {"1-mode", "4-modes", "8-modes", "16-modes", "32-modes"}) {
        Hearing const found = level == "32-modes" ? right : listen(gameData, level, bodies, frames);
        double error = 0;
        double heard = 0;
        for (auto const& [when, brightness] : right.brightness) {
            auto const here = found.brightness.find(when);
            error += std::abs(brightness - (here == found.brightness.end() ? 0 : here->second));
            ++heard;
        }
        ladder.rungs.push_back({level, found.microseconds, heard > 0 ? error / heard : 0, {}, false, {}});
    }
    ladder.remark = "Times are means over the frames, not medians, as impacts take most of the time, and "
                    "they are the world's times. The synthesis for loudspeakers, which is not included, "
                    "renders only the audible modes, so more modes take little more time (bench_sound).";
    return ladder;
}

} // namespace

void addSoundPlans(std::vector<Plan>& plans) {
    plans.push_back({"sound", climbModes});
}

} // namespace trembler::accuracy
