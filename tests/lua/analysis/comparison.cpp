#include "tests/lua/analysis/comparison.hpp"

#include "lua/attach/register.hpp"
#include "lua/component/scripted_interaction.hpp"
#include "puzzle/data/effects.hpp"
#include "puzzle/session/session.hpp"
#include "runtime/level/read/read_level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

namespace trembler::lua::analysis {
namespace {

/// A recorded play of a level; without a solution there is no player input.
struct Play {
    std::filesystem::path path;
    Solution const* solution = nullptr;
    std::uint64_t frames = 0;
};
struct Played {
    std::vector<std::uint64_t> hashes; // after each frame
    std::vector<ComponentStatus> status;
};

/// The properties that propertyHash() covers besides the columns, in the order of the keys.
std::vector<PropertyInfo const*> hashedOffers(Registry const& registry) {
    std::map<std::string_view, PropertyInfo const*> offered;
    for (Registration const& registration : registry.components()) {
        for (PropertyInfo const* offer : registration.info->offers) {
            if (offer->coverage.kind == Coverage::Kind::hashed) {
                offered.emplace(offer->text.key, offer);
            }
        }
    }
    std::vector<PropertyInfo const*> all;
    for (auto const& [key, info] : offered) {
        all.push_back(info);
    }
    return all;
}

std::uint64_t hashOf(Store const& store, std::vector<PropertyInfo const*> const& offers) {
    StateHash hash;
    store.hash(hash);
    for (PropertyInfo const* const info : offers) {
        if (SlotBase const* const slot = store.findSlot(*info)) {
            hash.value(std::string(info->text.key));
            slot->hash(hash);
        }
    }
    return hash.digest();
}

Played run(Registry const& registry, PartLibrary const& parts, LevelFile const& level, Play const& play) {
    std::vector<PropertyInfo const*> const offers = hashedOffers(registry);
    Session session(registry, parts, level);
    if (play.solution != nullptr) {
        session.load(*play.solution);
    }
    Played played;
    for (std::uint64_t frame = 0; frame < play.frames; ++frame) {
        session.step();
        played.hashes.push_back(hashOf(session.world().store(), offers));
    }
    played.status = session.world().status();
    return played;
}

ComponentStatus const& statusIn(Played const& played, std::string_view name) {
    return *std::find_if(played.status.begin(), played.status.end(), [&](ComponentStatus const& status) {
        return status.info->kind == ComponentKind::interaction && status.info->text.name == name;
    });
}

/// Interactions, and a registry with their scripts in their places.
struct Candidate {
    Candidate(std::string const& name, std::vector<Counterpart> const& counterparts)
        : log(std::make_shared<ScriptLog>()) {
        comparison.name = name;
        registerEffects(registry);
        for (Counterpart const& counterpart : counterparts) {
            putInPlace(registry, counterpart, log);
            replaced.push_back(counterpart.name);
        }
    }
    std::vector<std::string> replaced;
    Registry registry;
    std::shared_ptr<ScriptLog> log;
    Comparison comparison;
    double nativeTotal = 0; // µs
    double scriptTotal = 0;
    std::uint64_t scriptTurns = 0;
};

void compare(Candidate& candidate, GameData const& data, LevelFile const& level, Play const& play,
             Played const& native) {
    Comparison& comparison = candidate.comparison;
    auto const hasTurns = [&](std::string const& name) {
        ComponentStatus const& status = statusIn(native, name);
        return status.activity != Activity::absent && status.updates > 0;
    };
    if (std::none_of(candidate.replaced.begin(), candidate.replaced.end(), hasTurns)) {
        return;
    }
    Played const scripted = run(candidate.registry, data.parts, level, play);
    ++comparison.plays;
    comparison.frames += play.frames;
    for (std::string const& name : candidate.replaced) {
        ComponentStatus const& before = statusIn(native, name);
        ComponentStatus const& after = statusIn(scripted, name);
        comparison.turns += before.updates;
        candidate.nativeTotal += before.totalMicroseconds;
        candidate.scriptTotal += after.totalMicroseconds;
        candidate.scriptTurns += after.updates;
    }
    auto const at = std::mismatch(native.hashes.begin(), native.hashes.end(), scripted.hashes.begin(),
                                  scripted.hashes.end());
    if (at.first != native.hashes.end()) {
        auto const frame = static_cast<std::uint64_t>(at.first - native.hashes.begin()) + 1;
        ++comparison.differing;
        if (!comparison.firstDiffers || frame < *comparison.firstDiffers) {
            comparison.firstDiffers = frame;
            comparison.differsIn = fmt::format("{}, {}", data.shortName(play.path),
                                               play.solution == nullptr ? "hands off" : play.solution->name);
        }
    }
    for (ScriptMessage const& message : candidate.log->take()) {
        comparison.errors.push_back(message.text);
    }
}

std::vector<Comparison> compareEach(std::vector<std::unique_ptr<Candidate>> candidates, GameData const& data,
                                    std::vector<std::filesystem::path> const& levels, std::uint64_t frames) {
    for (std::filesystem::path const& path : levels) {
        LevelFile const level = loadLevel(data.registry, path);
        std::vector<Play> plays;
        for (Solution const& solution : level.solutions) {
            plays.push_back({path, &solution,
                             std::min(frames, static_cast<std::uint64_t>(solution.frames.value_or(600)))});
        }
        if (plays.empty()) {
            plays.push_back({path, nullptr, std::min<std::uint64_t>(frames, 600)});
        }
        for (Play const& play : plays) {
            Played const native = run(data.registry, data.parts, level, play);
            for (auto const& candidate : candidates) {
                compare(*candidate, data, level, play, native);
            }
        }
    }
    std::vector<Comparison> all;
    for (auto const& candidate : candidates) {
        Comparison& made = candidate->comparison;
        made.nativeMicroseconds =
            made.turns == 0 ? 0 : candidate->nativeTotal / static_cast<double>(made.turns);
        made.scriptMicroseconds = candidate->scriptTurns == 0
                                      ? 0
                                      : candidate->scriptTotal / static_cast<double>(candidate->scriptTurns);
        all.push_back(std::move(made));
    }
    return all;
}

} // namespace

void putInPlace(Registry& registry, Counterpart const& counterpart, std::shared_ptr<ScriptLog> const& log) {
    Problems problems;
    Manifest manifest = loadManifest(counterpart.script, problems);
    problems.throwIfAny();
    auto const at = std::find_if(registry.components().begin(), registry.components().end(),
                                 [&](Registration const& registration) {
                                     return registration.info->kind == ComponentKind::interaction &&
                                            registration.info->text.name == manifest.name;
                                 });
    if (at == registry.components().end()) {
        throw std::runtime_error("there is no interaction " + manifest.name);
    }
    auto const script =
        declare(std::move(manifest), std::string(at->info->text.effect), Vocabulary(registry), problems);
    problems.throwIfAny();
    // A registry has no function that replaces a component: only tests do.
    auto& place = const_cast<Registration&>(*at); // NOLINT(cppcoreguidelines-pro-type-const-cast)
    auto const info = std::make_shared<ComponentInfo>(*script->info);
    info->type = place.info->type;
    info->text = place.info->text;
    info->neededAll = place.info->neededAll;
    info->neededAny = place.info->neededAny;
    info->inSetup = place.info->inSetup;
    place.info = info.get();
    place.make = [script, log, info]() -> std::unique_ptr<Component> {
        return std::make_unique<ScriptedInteraction>(script, log);
    };
}

std::uint64_t propertyHash(World const& world, Registry const& registry) {
    return hashOf(world.store(), hashedOffers(registry));
}

std::vector<std::filesystem::path> comparedLevels(GameData const& data) {
    std::vector<std::filesystem::path> levels = data.levels();
    std::vector<std::filesystem::path> own;
    for (auto const& entry : std::filesystem::directory_iterator(std::filesystem::path(TREMBLER_SOURCE_DIR) /
                                                                 "tests/lua/analysis/levels")) {
        own.push_back(entry.path());
    }
    std::sort(own.begin(), own.end());
    levels.insert(levels.end(), own.begin(), own.end());
    return levels;
}

std::vector<Comparison> compareAll(GameData const& data, std::vector<std::filesystem::path> const& levels,
                                   std::uint64_t frames) {
    std::vector<std::unique_ptr<Candidate>> candidates;
    for (Counterpart const& counterpart : counterparts()) {
        if (!counterpart.script.empty()) {
            candidates.push_back(std::make_unique<Candidate>(counterpart.name, std::vector{counterpart}));
        }
    }
    return compareEach(std::move(candidates), data, levels, frames);
}

Comparison compareTogether(GameData const& data, std::vector<std::filesystem::path> const& levels,
                           std::uint64_t frames, std::vector<Counterpart> const& counterparts) {
    std::vector<std::unique_ptr<Candidate>> candidates;
    candidates.push_back(std::make_unique<Candidate>("several scripts together", counterparts));
    return compareEach(std::move(candidates), data, levels, frames).front();
}

} // namespace trembler::lua::analysis
