#include "insight/why/candidates.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace trembler::insight {
namespace {

using Pair = std::pair<std::string, std::string>;

/// The inputs of a grip: from the grab on until the hand lets go.
std::vector<LeftOut> grip(Solution const& solution, Step const& step) {
    std::vector<LeftOut> all;
    int hand = -1;
    for (std::size_t i = 0; i < solution.inputs.size(); ++i) {
        RecordedInput const& input = solution.inputs[i];
        if (hand < 0 && input.kind == PlayerInput::Kind::grab && input.frame == step.frame &&
            input.object == step.objects.front()) {
            hand = input.hand;
            all.push_back(withoutInput(i));
        } else if (hand >= 0 && input.hand == hand) {
            if (input.kind == PlayerInput::Kind::grab) {
                break;
            }
            if (input.kind == PlayerInput::Kind::move || input.kind == PlayerInput::Kind::release) {
                all.push_back(withoutInput(i));
            }
            if (input.kind == PlayerInput::Kind::release) {
                break;
            }
        }
    }
    return all;
}

std::vector<LeftOut> deed(Solution const& solution, Step const& step, PlayerInput::Kind kind) {
    for (std::size_t i = 0; i < solution.inputs.size(); ++i) {
        RecordedInput const& input = solution.inputs[i];
        bool const same = input.object == step.objects.front() ||
                          (step.objects.size() > 1 && input.object == step.objects[1]);
        if (input.kind == kind && input.frame == step.frame && same) {
            return {withoutInput(i)};
        }
    }
    return {};
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
    std::map<Pair, std::size_t> contacts;
    std::map<Pair, std::size_t> dips;
    std::vector<std::size_t> const& proximate = story.askedStep().because;
    for (std::size_t i = 0; i < story.steps.size(); ++i) {
        Step const& step = story.steps[i];
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
        case StepKind::grabbed:
            leftOut = grip(solution, step);
            break;
        case StepKind::cut:
            leftOut = deed(solution, step, PlayerInput::Kind::cut);
            break;
        case StepKind::removed:
            leftOut = deed(solution, step, PlayerInput::Kind::remove);
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
