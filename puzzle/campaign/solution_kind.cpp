#include "puzzle/campaign/solution_kind.hpp"

#include "puzzle/session/session.hpp"
#include "runtime/trace/tracer.hpp"

#include <algorithm>

namespace trembler {

KindOfRun kindOf(Registry const& registry, PartLibrary const& parts, LevelFile const& level,
                 Solution const& solution, std::uint64_t most) {
    KindOfRun found;
    for (Placement const& placement : solution.placements) {
        found.kind.parts.insert(placement.part);
    }
    WorldOptions options;
    options.detail = level.detail;
    options.trace = true;
    Session session(registry, parts, level, options);
    session.load(solution);
    while (session.world().frame() < most && !session.solved()) {
        session.step();
    }
    found.solves = session.solved();
    // Deeds after the level was solved had no part in it.
    for (RecordedInput const& input : session.inputs()) {
        using Kind = PlayerInput::Kind;
        if (input.kind == Kind::grab || input.kind == Kind::cut || input.kind == Kind::remove) {
            found.kind.actions.emplace(playerInputNames[static_cast<std::size_t>(input.kind)]);
        }
    }
    if (Tracer const* const tracer = session.world().tracer()) {
        for (EventId const cause : session.judge().causes(session.world())) {
            for (EventId const event : tracer->chain(cause)) {
                if (Event const* const known = tracer->find(event)) {
                    found.kind.causes.insert(known->component);
                }
            }
        }
    }
    return found;
}

bool differInKind(SolutionKind const& a, SolutionKind const& b) {
    if (a.actions != b.actions || a.causes != b.causes) {
        return true;
    }
    auto const within = [](std::set<std::string> const& few, std::set<std::string> const& many) {
        return std::includes(many.begin(), many.end(), few.begin(), few.end());
    };
    return !within(a.parts, b.parts) && !within(b.parts, a.parts);
}

} // namespace trembler
