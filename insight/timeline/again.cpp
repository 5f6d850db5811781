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

} // namespace

std::unique_ptr<LevelRun> buildAgain(Registry const& registry, Session const& session) {
    return std::make_unique<LevelRun>(
        registry, session.parts(), session.level(), placementsOf(session.placed()), session.world().options(),
        connectionsOf(session.wires(), WireEnds(session.level(), session.parts(), session.placed())));
}

Playback playbackTo(Session const& session, std::uint64_t frame) {
    return {upTo(session.inputs(), frame), upTo(session.changes(), frame)};
}

} // namespace trembler::insight
