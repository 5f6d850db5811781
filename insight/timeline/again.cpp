#include "insight/timeline/again.hpp"

#include <algorithm>
#include <iterator>

namespace trembler::insight {
namespace {

template <class Recorded>
std::vector<Recorded> upTo(std::span<Recorded const> all, std::uint64_t frame) {
    std::vector<Recorded> some;
    std::copy_if(all.begin(), all.end(), std::back_inserter(some),
                 [frame](Recorded const& each) { return each.frame <= frame; });
    return some;
}

/// The world's present options may differ from the options that the run began with: the run may have changed
/// them.
WorldOptions optionsAtStart(Session const& session) {
    WorldOptions options = session.world().options();
    std::uint64_t const last = session.world().frame();
    auto const later = static_cast<std::size_t>(
        std::count_if(session.changes().begin(), session.changes().end(),
                      [last](RecordedChange const& change) { return change.frame <= last; }));
    options.detail = session.level().detail;
    options.periods.clear();
    std::vector<RecordedChange> const changes = session.record("").changes; // those before the start first
    for (std::size_t i = 0; i + later < changes.size(); ++i) {
        RecordedChange const& change = changes[i];
        if (change.kind == RecordedChange::Kind::period) {
            options.periods[change.subject] = static_cast<int>(change.value);
        } else if (change.level.empty()) {
            options.detail.erase(change.subject);
        } else {
            options.detail[change.subject] = change.level;
        }
    }
    return options;
}

} // namespace

std::unique_ptr<LevelRun> buildAgain(Registry const& registry, Session const& session) {
    return std::make_unique<LevelRun>(
        registry, session.parts(), session.level(), placementsOf(session.placed()), optionsAtStart(session),
        connectionsOf(session.wires(), WireEnds(session.level(), session.parts(), session.placed())));
}

Playback playbackTo(Session const& session, std::uint64_t frame) {
    return {upTo(session.inputs(), frame), upTo(session.changes(), frame)};
}

} // namespace trembler::insight
