#include "insight/why/runs/in_the_way.hpp"

#include "insight/why/runs/goal_runs.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace trembler::insight {
namespace in_the_way {
namespace {

/// Something that may have stood in the way.
struct Suspect {
    std::string name;    ///< of the object, or of the piece of a part that touched first
    std::string blocked; ///< what it touched
    bool placed = false;
    std::uint64_t frame = 0; ///< of the first touch
    std::vector<LeftOut> leftOut;
};

/// Whether the object is that of the goal, or joints tie it to that one.
bool movesWith(std::string const& name, std::string const& mover, SceneFacts const& facts) {
    auto const group = facts.tied.find(mover);
    auto const own = facts.tied.find(name);
    return name == mover ||
           (group != facts.tied.end() && own != facts.tied.end() && group->second == own->second);
}

/// Whether the miss names the object: as one that should be touched, or as an obstacle or a load by now.
bool isNamed(std::string const& name, Miss const& miss) {
    return std::find(miss.names.begin(), miss.names.end(), name) != miss.names.end() ||
           std::any_of(miss.besides.begin(), miss.besides.end(),
                       [&](Miss const& other) { return isNamed(name, other); });
}

/// The suspect that would be left out in the same run; the end if there is none.
std::vector<Suspect>::iterator sameIn(std::vector<Suspect>& all, std::string const& name,
                                      SceneFacts const& facts) {
    auto const placement = facts.placementOf.find(name);
    return std::find_if(all.begin(), all.end(), [&](Suspect const& one) {
        auto const other = facts.placementOf.find(one.name);
        return one.name == name || (placement != facts.placementOf.end() &&
                                    other != facts.placementOf.end() && placement->second == other->second);
    });
}

std::vector<Suspect> suspectsOf(Miss const& nearest, SceneFacts const& facts) {
    std::string const& mover = nearest.names.front();
    std::vector<Suspect> all;
    for (auto const& [pair, frame] : facts.firstTouch) {
        if (pair.size() != 2 || movesWith(pair[0], mover, facts) == movesWith(pair[1], mover, facts)) {
            continue;
        }
        bool const first = movesWith(pair[0], mover, facts);
        std::string const& own = pair[first ? 0 : 1];
        std::string const& other = pair[first ? 1 : 0];
        auto const placement = facts.placementOf.find(other);
        bool const placed = placement != facts.placementOf.end();
        if (isNamed(other, nearest) || (!placed && facts.fixed.contains(other))) {
            continue;
        }
        auto const same = sameIn(all, other, facts);
        if (same == all.end()) {
            all.push_back({other, own, placed, frame, {}});
            if (placed) {
                all.back().leftOut.push_back(withoutPlacement(placement->second));
            } else {
                all.back().leftOut.push_back(withoutContact(own, other));
            }
            continue;
        }
        if (!placed) {
            same->leftOut.push_back(withoutContact(own, other));
        }
        if (frame < same->frame) {
            same->name = other;
            same->blocked = own;
            same->frame = frame;
        }
    }
    std::stable_sort(all.begin(), all.end(), [](Suspect const& a, Suspect const& b) {
        return std::pair(!a.placed, a.frame) < std::pair(!b.placed, b.frame);
    });
    all.resize(std::min(all.size(), mostInTheWay));
    return all;
}

} // namespace
} // namespace in_the_way

void addInTheWay(LevelRuns const& runs, Solution const& solution, AskOptions const& options, Answer& answer) {
    if (!answer.complete || !answer.nearest || answer.nearest->nearest.names.empty() ||
        answer.nearest->nearest.lack != Lack::distance) {
        return;
    }
    std::vector<in_the_way::Suspect> const suspects =
        in_the_way::suspectsOf(answer.nearest->nearest, answer.facts);
    std::vector<Variation> variations;
    for (in_the_way::Suspect const& suspect : suspects) {
        variations.push_back({solution, suspect.leftOut});
    }
    addWhatCameNearer(runs, options, answer, variations,
                      [&](std::size_t i) { return missOfBlocked(suspects[i].name, suspects[i].blocked); });
}

} // namespace trembler::insight
