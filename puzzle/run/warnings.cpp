#include "puzzle/run/warnings.hpp"

#include "physics/dynamics/properties/engine_state.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {

std::vector<std::string> warningsOf(World const& world) {
    std::vector<std::string> warnings;
    EngineState const* const state = world.find<EngineState>();
    if (state == nullptr || !state->troubled()) {
        return warnings;
    }
    if (!state->gaveUp.empty()) {
        warnings.push_back(fmt::format("the engine {} failed ({}); Box2D computes the motion instead",
                                       state->gaveUp, state->why));
    }
    if (!state->stopped.empty()) {
        constexpr std::size_t most = 5;
        std::string names;
        for (std::size_t i = 0; i < std::min(most, state->stopped.size()); ++i) {
            std::string const name = world.store().nameOf(state->stopped[i]);
            names += fmt::format("{}{}", i == 0 ? "" : ", ",
                                 name.empty() ? "an object that no longer exists" : name);
        }
        if (state->stopped.size() > most) {
            names += fmt::format(" and {} more", state->stopped.size() - most);
        }
        warnings.push_back(
            fmt::format("Box2D could not compute the motion of {} ({}); from then on it is held still", names,
                        state->why));
    }
    return warnings;
}

std::vector<std::string> refusedPlaces(Session const& session) {
    std::vector<std::string> warnings;
    if (session.mode() != SessionMode::building) {
        return warnings;
    }
    for (PlacedPart const& part : session.placed()) {
        if (Verdict const verdict = session.check(part.placement, part.number); !verdict.ok) {
            warnings.push_back(fmt::format("a player cannot place the {} at ({:.3g}, {:.3g}): {}",
                                           session.world().store().nameOf(session.objectOf(part.number)),
                                           part.placement.at.x, part.placement.at.y, verdict.why));
        }
    }
    return warnings;
}

} // namespace trembler
