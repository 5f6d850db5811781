#include "insight/why/runs/candidates.hpp"

#include "insight/why/story/deed_steps.hpp"

#include <algorithm>
#include <iterator>
#include <map>
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
    std::map<Pair, std::size_t> contacts;
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
            Pair const pair = std::minmax(step.objects[0], step.objects[1]);
            if (auto const [at, isNew] = contacts.emplace(pair, all.size()); !isNew) {
                all[at->second].steps.push_back(i);
                continue;
            }
            // Without the pair's first contact the run is the same until then, from whichever frame on.
            auto const first = facts.firstTouch.find(step.objects);
            bool const isFirst = first == facts.firstTouch.end() || first->second == step.frame;
            leftOut = {withoutContact(pair.first, pair.second, isFirst ? 1 : step.frame)};
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
