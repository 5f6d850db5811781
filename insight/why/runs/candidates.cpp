#include "insight/why/runs/candidates.hpp"

#include "insight/why/story/deed_steps.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace trembler::insight {
namespace {

using Pair = std::pair<std::string, std::string>;

std::vector<LeftOut> leftOutOf(Deed const* deed) {
    std::vector<LeftOut> all;
    if (deed != nullptr) {
        std::transform(deed->inputs.begin(), deed->inputs.end(), std::back_inserter(all), withoutInput);
    }
    return all;
}

/// The objects with the role of an object, itself included.
std::vector<std::string> sharingRole(std::string const& name, SceneFacts const& facts) {
    auto const role = facts.roles.find(name);
    std::vector<std::string> all;
    for (auto const& [other, number] : facts.roles) {
        if (role != facts.roles.end() && number == role->second) {
            all.push_back(other);
        }
    }
    return all.empty() ? std::vector{name} : all;
}

/// The first frame from which a run can be without the contact of a pair. Without the first contact of the
/// run it is the same until then, from whichever frame on.
std::uint64_t leftOutFrom(Pair const& pair, std::uint64_t frame, SceneFacts const& facts) {
    auto const first = facts.firstTouch.find({pair.first, pair.second});
    return first == facts.firstTouch.end() || first->second == frame ? 1 : frame;
}

/// The contacts of pairs in each of which the objects have the roles of the same two objects.
class ContactCandidates {
public:
    explicit ContactCandidates(SceneFacts const& facts) : facts_(facts) {}

    /// Adds a step of the story to the candidate of its pair, which it makes if there is none.
    void add(Step const& step, std::size_t place, std::vector<Candidate>& all) {
        Pair const pair = std::minmax(step.objects[0], step.objects[1]);
        std::vector<Pair> const alike = pairsLike(pair);
        auto const [at, isNew] = candidates_.emplace(alike.front(), all.size());
        if (isNew) {
            all.emplace_back();
        }
        Candidate& candidate = all[at->second];
        candidate.steps.push_back(place);
        std::set<Pair>& known = pairs_[alike.front()];
        if (!known.insert(pair).second) {
            return;
        }
        if (known.size() == 2) { // they take turns, so the others may take theirs
            candidate.leftOut.clear();
            for (Pair const& each : alike) {
                candidate.leftOut.push_back(withoutContact(each.first, each.second, 1));
            }
        } else if (known.size() == 1) {
            candidate.leftOut = {
                withoutContact(pair.first, pair.second, leftOutFrom(pair, step.frame, facts_))};
        }
    }

private:
    /// Ascending.
    [[nodiscard]] std::vector<Pair> pairsLike(Pair const& pair) const {
        std::vector<Pair> all;
        for (std::string const& a : sharingRole(pair.first, facts_)) {
            for (std::string const& b : sharingRole(pair.second, facts_)) {
                if (a != b) {
                    all.push_back(std::minmax(a, b));
                }
            }
        }
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        return all;
    }

    SceneFacts const& facts_;
    std::map<Pair, std::size_t> candidates_; // by the first of the pairs that are alike
    std::map<Pair, std::set<Pair>> pairs_;   // of each candidate, those in the story
};

/// What to leave out so that a magnet does not do what a step tells: the magnet, or, of iron to which a
/// magnet is drawn, that magnet.
std::string const& deviceOf(Step const& step, SceneFacts const& facts) {
    return facts.magnets.contains(step.objects.back()) ? step.objects.back() : step.objects.front();
}

/// All wires between the two objects.
std::vector<LeftOut> wiresOf(Step const& step, Solution const& solution) {
    std::vector<LeftOut> all;
    for (std::size_t i = 0; i < solution.wires.size(); ++i) {
        if (solution.wires[i].a == step.objects[0] && solution.wires[i].b == step.objects[1]) {
            all.push_back(withoutWire(i));
        }
    }
    return all;
}

} // namespace

bool isGranted(Step const& step, SceneFacts const& facts) {
    if (step.kind != StepKind::contact || step.objects.size() != 2) {
        return false;
    }
    bool const circuit =
        facts.conductors.contains(step.objects[0]) && facts.conductors.contains(step.objects[1]);
    return !circuit && std::any_of(step.objects.begin(), step.objects.end(), [&](std::string const& name) {
        return facts.fixed.contains(name) && !facts.placementOf.contains(name);
    });
}

std::vector<Candidate> candidatesOf(Story const& story, SceneFacts const& facts, Solution const& solution,
                                    bool everything) {
    std::vector<Candidate> all;
    DeedFinder deeds(solution);
    ContactCandidates contacts(facts);
    std::map<std::string, std::size_t> devices;
    std::map<Pair, std::size_t> dips;
    std::vector<std::size_t> const& proximate = story.askedStep().because;
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
        Step const& step = story.steps[i];
        if (step.bridge) {
            continue;
        }
        std::vector<LeftOut> leftOut;
        switch (step.kind) {
        case StepKind::contact: {
            if (i == story.asked || step.objects.size() != 2 || (!everything && isGranted(step, facts))) {
                continue;
            }
            bool const itself = story.askedStep().kind == StepKind::goal &&
                                std::binary_search(proximate.begin(), proximate.end(), i) &&
                                std::all_of(step.objects.begin(), step.objects.end(), [&](auto const& name) {
                                    auto const& about = story.askedStep().objects;
                                    return std::find(about.begin(), about.end(), name) != about.end();
                                });
            if (itself) {
                continue;
            }
            contacts.add(step, i, all);
            continue;
        }
        case StepKind::pull:
        case StepKind::push: {
            // Without its magnet, a pull that was asked about cannot happen, whatever that shows.
            bool const itself =
                isPull(story.askedStep().kind) && deviceOf(step, facts) == deviceOf(story.askedStep(), facts);
            if (itself) {
                continue;
            }
            std::string const& device = deviceOf(step, facts);
            if (auto const [at, isNew] = devices.emplace(device, all.size()); !isNew) {
                all[at->second].steps.push_back(i);
                continue;
            }
            leftOut = {withoutDevice(device, step.frame)};
            break;
        }
        case StepKind::liquid:
            if (i == story.asked || step.objects.size() != 2) {
                continue;
            }
            if (auto const [at, isNew] = dips.emplace(Pair(step.objects[0], step.objects[1]), all.size());
                !isNew) {
                all[at->second].steps.push_back(i);
                continue;
            }
            leftOut = {withoutDip(step.objects[0], step.objects[1], step.frame)};
            break;
        case StepKind::placed:
            leftOut = {withoutPlacement(facts.placementOf.at(step.objects.front()))};
            break;
        case StepKind::wired:
            leftOut = wiresOf(step, solution);
            break;
        case StepKind::grabbed:
        case StepKind::cut:
        case StepKind::removed:
            leftOut = leftOutOf(deeds.find(step));
            break;
        default:
            break;
        }
        if (!leftOut.empty()) {
            all.push_back({std::move(leftOut), {i}});
        }
    }
    return all;
}

} // namespace trembler::insight
