#include "insight/why/runs/not_pushed.hpp"

#include "insight/miss/push/needed_push.hpp"
#include "insight/why/runs/goal_runs.hpp"
#include "physics/dynamics/properties/shapes/mass_properties.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace trembler::insight {
namespace not_pushed {
namespace {

constexpr std::size_t mostPushes = 4; // that are tested
constexpr double tolerance = 1.0 / 6; // of the force: a hand also slows down what it turns
constexpr double slack = 0.05;        // N
constexpr double farAway = 1000;      // m: a hand that wants to be there pulls as hard as it can

/// A body to be pushed, and the gaps that this closes.
struct Push {
    std::string body;
    Vec2 grip; ///< m, in the world at the start of the run: its centre of mass
    NeededPush needed;
    std::vector<std::pair<std::string, std::string>> gaps;
};

void addGaps(std::vector<CircuitGap> const& gaps, World const& world, std::vector<Push>& to) {
    load::Neighbours const neighbours(world);
    for (CircuitGap gap : gaps) {
        gap.a = world.store().find(gap.nameA); // of this run
        gap.b = world.store().find(gap.nameB);
        auto const needed =
            gap.a.valid() && gap.b.valid() ? neededPush(world, neighbours, gap) : std::nullopt;
        if (!needed) {
            continue;
        }
        std::string const body = world.store().nameOf(needed->body);
        auto at = std::find_if(to.begin(), to.end(), [&](Push const& push) { return push.body == body; });
        if (at == to.end() && to.size() < mostPushes) {
            at = to.insert(to.end(), {body, {}, *needed, {}});
        }
        if (at != to.end() && dot(at->needed.direction, needed->direction) > 0) {
            at->needed.force = std::max(at->needed.force, needed->force);
            at->gaps.emplace_back(gap.nameA, gap.nameB);
        }
    }
}

/// The pushes for the gaps of a miss, in a repetition of the run.
std::vector<Push> pushesFor(LevelRuns const& runs, Solution const& solution, AskOptions const& options,
                            Miss const& nearest) {
    std::map<std::uint64_t, std::vector<CircuitGap>> gaps; // by frame
    gaps[nearest.frame] = nearest.gaps;
    for (Miss const& other : nearest.besides) {
        std::vector<CircuitGap>& all = gaps[other.frame == 0 ? nearest.frame : other.frame];
        all.insert(all.end(), other.gaps.begin(), other.gaps.end());
    }
    std::erase_if(gaps, [](auto const& each) { return each.second.empty(); });
    std::vector<Push> pushes;
    if (gaps.empty()) {
        return pushes;
    }
    std::map<std::string, Vec2> centres; // m, before the first frame
    RunObserver observer;
    observer.begin = [&](LevelRun const& run) {
        Store const& store = run.world().store();
        auto const* const shapes = store.findColumn<Shape>();
        for (std::size_t row = 0; shapes != nullptr && row < shapes->size(); ++row) {
            ObjectId const id = shapes->owners()[row];
            Position const* const at = run.world().find<Position>(id);
            Rotation const* const turned = run.world().find<Rotation>(id);
            if (at != nullptr && !shapes->values()[row].pieces.empty()) {
                Vec2 const centre = centreOfMass(shapes->values()[row]);
                centres.emplace(store.nameOf(id),
                                at->value + rotated(centre, turned == nullptr ? 0 : turned->angle));
            }
        }
    };
    observer.frame = [&](LevelRun const& run) {
        if (auto const at = gaps.find(run.world().frame()); at != gaps.end()) {
            addGaps(at->second, run.world(), pushes);
        }
        return run.world().frame() < gaps.rbegin()->first && !(options.stop && options.stop());
    };
    (void)runs.run({solution}, {.frames = options.frames, .stopWhenSolved = true, .trace = false}, observer);
    for (Push& push : pushes) {
        push.grip = centres[push.body];
    }
    return pushes;
}

/// The run in which a hand pushes so much harder than needed, or less hard; at most two at once.
Variation pushing(Solution const& solution, std::span<Push const> pushes, double share) {
    Variation made{solution, {}};
    double strength = 0; // of the hands, which are equally strong: only equal pushes can be made together
    int hand = 0;
    for (Push const& push : pushes) {
        RecordedInput grab;
        grab.kind = PlayerInput::Kind::grab;
        grab.object = push.body;
        grab.at = push.grip;
        grab.hand = hand++;
        RecordedInput pull = grab;
        pull.kind = PlayerInput::Kind::move;
        pull.object.clear();
        pull.frame = 2;
        pull.at = push.grip + farAway * push.needed.direction;
        made.solution.inputs.push_back(grab);
        made.solution.inputs.push_back(pull);
        // Its direction stays the same, while that of something that turns changes by half of this each way.
        double const slanted = share > 1 ? std::cos(0.5 * push.needed.turn) : 1;
        strength = std::max(strength, share * push.needed.force / std::max(slanted, 0.1) +
                                          (share > 1 ? slack : -slack));
    }
    made.handStrength = std::max(strength, 1e-3);
    std::stable_sort(made.solution.inputs.begin(), made.solution.inputs.end(),
                     [](RecordedInput const& a, RecordedInput const& b) { return a.frame < b.frame; });
    return made;
}

Miss missOf(Push const& push, IfClosed ifClosed) {
    Miss miss;
    miss.lack = push.needed.touched ? Lack::push : Lack::unpushed;
    miss.by = push.needed.force;
    miss.names = {push.body};
    miss.ifClosed = ifClosed;
    return miss;
}

} // namespace
} // namespace not_pushed

void addNotPushed(LevelRuns const& runs, Solution const& solution, AskOptions const& options,
                  Answer& answer) {
    using not_pushed::Push;
    bool const byHand =
        std::any_of(solution.inputs.begin(), solution.inputs.end(),
                    [](RecordedInput const& input) { return input.kind == PlayerInput::Kind::grab; });
    if (!answer.complete || !answer.nearest || byHand) {
        return;
    }
    Miss& nearest = answer.nearest->nearest;
    GoalRuns again(runs, answer.nearest->id, nearest.measure, options, answer);
    std::vector<Push> const pushes = not_pushed::pushesFor(runs, solution, options, nearest);
    answer.runs += pushes.empty() ? 0 : 1;
    std::vector<Push> confirmed;
    std::vector<IfClosed> results;
    for (Push const& push : pushes) {
        std::vector<GoalRun> const tested =
            again.run({not_pushed::pushing(solution, std::span(&push, 1), 1 + not_pushed::tolerance),
                       not_pushed::pushing(solution, std::span(&push, 1), 1 - not_pushed::tolerance)},
                      {.device = {}, .pairs = push.gaps});
        if (tested.empty()) {
            return; // stopped
        }
        if (tested[0].touched && !tested[1].touched) {
            confirmed.push_back(push);
            results.push_back(tested[0].shown());
        }
    }
    if (confirmed.size() == 2) { // a hand for each
        std::vector<GoalRun> const both =
            again.run({not_pushed::pushing(solution, confirmed, 1 + not_pushed::tolerance)}, {});
        if (both.empty()) {
            return;
        }
        if (both[0].nearer) { // told once, of both
            nearest.besides.push_back(not_pushed::missOf(confirmed[0], IfClosed::unknown));
            nearest.besides.push_back(not_pushed::missOf(confirmed[1], both[0].shown()));
            return;
        }
    }
    for (std::size_t i = 0; i < confirmed.size(); ++i) {
        if (results[i] != IfClosed::unknown) {
            nearest.besides.push_back(not_pushed::missOf(confirmed[i], results[i]));
        }
    }
}

} // namespace trembler::insight
