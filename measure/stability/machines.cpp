// The machines of the thesis for ten minutes, and every level in the repository for half an hour.
#include "measure/stability/hard_case.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace trembler::stability {
namespace {

constexpr std::uint64_t minute = 3600;

GameData const& gameData() {
    static GameData const shared;
    return shared;
}

LevelFile experiment(char const* file) {
    return loadLevel(gameData().registry, gameData().home / "levels/experiments" / file);
}

std::unique_ptr<Session> play(LevelFile level, Setting const& setting) {
    level.world.set(setting.solver);
    WorldOptions options;
    options.threads = setting.threads;
    options.detail = level.detail;
    options.detail["dynamics"] = setting.engine;
    return std::make_unique<Session>(gameData().registry, gameData().parts, std::move(level), options);
}

void shift(LevelFile& level, std::string const& name, Vec2 by) {
    for (LevelObject& object : level.objects) {
        if (object.name == name) {
            object.properties.set(Position{object.properties.find<Position>()->value + by});
        }
    }
}

// The ratio of the most to the fewest rings per minute, without the first minute, which contains the switch's
// fall.
std::vector<Figure> doorbell(Setting const& setting, std::uint64_t seed) {
    Jitter jitter(seed);
    LevelFile level = experiment("2-doorbell.json");
    shift(level, "switch", {0, 0.02 * jitter()});
    auto const session = play(std::move(level), setting);
    World const& world = session->world();
    ObjectId const bell = world.store().find("bell");
    ObjectId const striker = world.store().find("striker");
    TouchingPair const pair{std::min(bell, striker), std::max(bell, striker), {}};
    std::vector<double> rings;
    std::vector<double> rates;
    while (world.frame() < 11 * minute) {
        session->step();
        auto const& contacts = *world.find<Contacts>();
        bool const rang = std::binary_search(contacts.begun.begin(), contacts.begun.end(), pair) ||
                          std::binary_search(contacts.brief.begin(), contacts.brief.end(), pair);
        if (rang) {
            rings.push_back(static_cast<double>(world.frame()));
        }
        if (world.frame() % minute == 0) {
            if (world.frame() > minute && rings.size() > 1) {
                rates.push_back(static_cast<double>(rings.size() - 1) / (rings.back() - rings.front()));
            }
            if (!rings.empty()) {
                rings.erase(rings.begin(), rings.end() - 1);
            }
        }
    }
    double const drift = rates.size() < 10 ? std::numeric_limits<double>::infinity()
                                           : *std::max_element(rates.begin(), rates.end()) /
                                                     *std::min_element(rates.begin(), rates.end()) -
                                                 1;
    return {{"rate drift", "%", 1, 100 * orWorst(drift)}};
}

// Starts at any angle. Compares the rate of whole turns in minutes 6 to 11 with that in minutes 1 to 6.
std::vector<Figure> motor(Setting const& setting, std::uint64_t seed) {
    Jitter jitter(seed);
    LevelFile level = experiment("3-electric-motor.json");
    double const angle = pi * jitter();
    Vec2 const centre = level.findObject("main axle")->properties.find<Position>()->value;
    for (LevelObject& object : level.objects) {
        if (object.name == "main axle" || object.name.starts_with("spoke ")) {
            Vec2 const at = object.properties.find<Position>()->value;
            Rotation const* const turned = object.properties.find<Rotation>();
            object.properties.set(Position{centre + rotated(at - centre, angle)});
            object.properties.set(Rotation{(turned == nullptr ? 0 : turned->angle) + angle});
        }
    }
    auto const session = play(std::move(level), setting);
    World const& world = session->world();
    ObjectId const axis = world.store().find("main axle");
    double const start = world.find<Rotation>(axis)->angle;
    double before = 0;
    std::vector<double> marks; // frames at which whole turns were completed
    while (world.frame() < 11 * minute) {
        session->step();
        double const now = (world.find<Rotation>(axis)->angle - start) / (2 * pi);
        double const next = std::floor(before) + 1; // it turns far less than one turn per frame
        if (next <= now) {
            marks.push_back(static_cast<double>(world.frame()) - 1 + (next - before) / (now - before));
        }
        before = now;
    }
    auto const rate = [&](double from, double to) {
        std::vector<double> some;
        std::copy_if(marks.begin(), marks.end(), std::back_inserter(some),
                     [&](double mark) { return mark >= from && mark <= to; });
        return some.size() < 10 ? std::numeric_limits<double>::quiet_NaN()
                                : static_cast<double>(some.size() - 1) / (some.back() - some.front());
    };
    return {{"rate drift", "%", 1,
             100 * orWorst(std::abs(rate(6 * minute, 11 * minute) / rate(minute, 6 * minute) - 1))}};
}

// Without player input. Counts objects that leave the level's bounds by more than a tenth of their size, each
// once, and non-finite positions in every frame.
std::vector<Figure> handsOff(Setting const& setting, std::filesystem::path const& path) {
    LevelFile level = loadLevel(gameData().registry, path);
    Box bounds = level.bounds.value_or(Box{{-1e3, -1e3}, {2e3, 2e3}});
    double const margin = 0.1 * std::max(bounds.size.x, bounds.size.y);
    bounds = {bounds.corner - Vec2{margin, margin}, bounds.size + Vec2{2 * margin, 2 * margin}};
    auto const session = play(std::move(level), setting);
    World const& world = session->world();
    std::map<std::string, bool> out;
    double odd = 0;
    for (int frame = 0; frame < 100000; ++frame) {
        session->step();
        auto const& positions = *world.store().findColumn<Position>();
        for (std::size_t row = 0; row < positions.owners().size(); ++row) {
            Vec2 const at = positions.values()[row].value;
            odd += isFinite(at) ? 0 : 1;
            if (!bounds.contains(at)) {
                out[world.store().nameOf(positions.owners()[row])] = true;
            }
        }
    }
    return {{"out of bounds", "", 0, static_cast<double>(out.size())}, {"not finite", "", 0, odd}};
}

// How the level looks after ten seconds without player input.
std::string versionOf(std::filesystem::path const& path) {
    LevelFile const level = loadLevel(gameData().registry, path);
    Session session(gameData().registry, gameData().parts, level,
                    WorldOptions{.threads = 1, .detail = level.detail, .periods = {}});
    for (int frame = 0; frame < 600; ++frame) {
        session.step();
    }
    return fmt::format("frame 600: {:016x}", session.world().stateHash());
}

} // namespace

std::vector<HardCase> machineCases() {
    std::vector<HardCase> cases{{"doorbell, ten minutes", "", doorbell, true, false},
                                {"motor, ten minutes", "", motor, true, false}};
    for (std::filesystem::path const& path : gameData().levels()) {
        cases.push_back({"1e5 frames hands off", gameData().shortName(path),
                         [path](Setting const& setting, std::uint64_t) { return handsOff(setting, path); },
                         false, false, false, [path] { return versionOf(path); }});
    }
    return cases;
}

} // namespace trembler::stability
