#include "insight/why/runs/held_back.hpp"

#include "insight/miss/idle_devices.hpp"
#include "insight/why/runs/goal_runs.hpp"
#include "physics/dynamics/properties/contacts.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace trembler::insight {
namespace held_back {
namespace {

constexpr std::uint64_t before = 10;   // frames before the nearest miss, from which on a touch counts
constexpr std::uint64_t after = 60;    // frames after it: something pushes against what blocks it
constexpr std::size_t mostBodies = 2;  // that stand in each other's way
constexpr std::size_t mostDevices = 6; // that are tested

/// A body that another one, nearer to the goal's object, ran against.
struct Barrier {
    std::string blocked;
    std::string by;
    std::vector<LeftOut> touches; ///< of the two and of what is tied to them
};

/// A device without current, and the bodies between it and the goal's object.
struct Suspect {
    std::vector<Barrier> barriers;
    Miss miss; ///< of the device, named
};

using Touches = std::map<ObjectId, std::set<ObjectId>>;

void noteTouches(World const& world, Touches& touches) {
    Contacts const* const contacts = world.find<Contacts>();
    if (contacts == nullptr) {
        return;
    }
    for (auto const* const pairs : {&contacts->current, &contacts->brief}) {
        for (TouchingPair const& pair : *pairs) {
            touches[pair.a].insert(pair.b);
            touches[pair.b].insert(pair.a);
        }
    }
}

/// Finds the suspects in a repetition of the run.
class SuspectFinder {
public:
    SuspectFinder(std::string mover, std::uint64_t frame, std::set<std::string> known)
        : mover_(std::move(mover)), frame_(frame), known_(std::move(known)) {}

    /// To be called after every frame; false: it has seen enough.
    bool look(World const& world) {
        std::uint64_t const now = world.frame();
        if (now + before >= frame_) {
            noteTouches(world, touches_);
        }
        if (now == frame_) {
            noteDevices(world);
        }
        return now < frame_ + after;
    }

    /// Those with the fewest bodies in between first. `world`: after the last frame.
    [[nodiscard]] std::vector<Suspect> suspects(World const& world) const {
        struct Reached {
            std::vector<ObjectId> bodies;
            std::vector<Barrier> barriers;
        };
        load::Neighbours const neighbours(world);
        std::vector<Suspect> found;
        std::set<ObjectId> seen;
        std::vector<Reached> open;
        ObjectId const mover = world.store().find(mover_);
        if (mover.valid()) {
            open.push_back({tiedBodies(world, neighbours, mover), {}});
            seen.insert(open.front().bodies.begin(), open.front().bodies.end());
        }
        for (std::size_t next = 0; next < open.size(); ++next) {
            Reached const here = open[next];
            for (ObjectId const device : idleDevicesOf(world, here.bodies)) {
                add(found, world, device, here.barriers);
            }
            if (here.barriers.size() == mostBodies) {
                continue;
            }
            for (auto const& [inner, outer] : touchedBy(here.bodies)) {
                std::vector<ObjectId> bodies = tiedBodies(world, neighbours, outer);
                if (bodies.empty() || !seen.insert(outer).second) {
                    continue; // fixed, or known
                }
                seen.insert(bodies.begin(), bodies.end());
                Reached there{bodies, here.barriers};
                there.barriers.push_back(barrierOf(world, here.bodies, inner, bodies, outer));
                if (here.barriers.empty()) {
                    there.barriers.back().blocked = mover_;
                }
                open.push_back(std::move(there));
            }
        }
        return found;
    }

private:
    void noteDevices(World const& world) {
        CircuitSight circuits;
        std::vector<ObjectId> all;
        for (std::uint32_t index = 0; index < world.store().objects().indexBound(); ++index) {
            ObjectId const id = world.store().objects().at(index);
            if (id.valid() && isIdle(world, id)) {
                Miss miss = missOfIdle(world, id, circuits);
                nameObjects(miss, world.store());
                devices_.emplace(id, std::move(miss));
            }
        }
    }

    void add(std::vector<Suspect>& to, World const& world, ObjectId device,
             std::vector<Barrier> const& barriers) const {
        auto const idle = devices_.find(device);
        bool const isNew = std::none_of(to.begin(), to.end(), [&](Suspect const& suspect) {
            return suspect.miss.objects.front() == device;
        });
        if (idle != devices_.end() && idle->second.lack == Lack::gap && isNew &&
            !known_.contains(world.store().nameOf(device)) && to.size() < mostDevices) {
            to.push_back({barriers, idle->second});
        }
    }

    /// Pairs of one of the bodies and another object that touched it.
    [[nodiscard]] std::vector<std::pair<ObjectId, ObjectId>>
    touchedBy(std::vector<ObjectId> const& bodies) const {
        std::vector<std::pair<ObjectId, ObjectId>> pairs;
        for (ObjectId const body : bodies) {
            if (auto const at = touches_.find(body); at != touches_.end()) {
                for (ObjectId const other : at->second) {
                    pairs.emplace_back(body, other);
                }
            }
        }
        return pairs;
    }

    [[nodiscard]] Barrier barrierOf(World const& world, std::vector<ObjectId> const& inside, ObjectId inner,
                                    std::vector<ObjectId> const& outside, ObjectId outer) const {
        Store const& store = world.store();
        Barrier made{store.nameOf(inner), store.nameOf(outer), {}};
        std::set<ObjectId> touched;
        for (auto const& [a, b] : touchedBy(inside)) {
            if (std::binary_search(outside.begin(), outside.end(), b)) {
                touched.insert(b);
            }
        }
        for (ObjectId const a : inside) {
            for (ObjectId const b : touched) {
                made.touches.push_back(withoutContact(store.nameOf(a), store.nameOf(b)));
            }
        }
        return made;
    }

    std::string mover_;
    std::uint64_t frame_; // of the nearest miss
    std::set<std::string> known_;
    Touches touches_;
    std::map<ObjectId, Miss> devices_; // idle ones, in that frame
};

/// The run with wires across the gaps, which nobody cuts.
Variation closing(Solution solution, Miss const& miss) {
    for (CircuitGap const& gap : miss.gaps) {
        std::string const a = std::min(gap.nameA, gap.nameB);
        std::string const b = std::max(gap.nameA, gap.nameB);
        auto const isPair = [&](std::string const& x, std::string const& y) {
            return (x == a && y == b) || (x == b && y == a);
        };
        std::erase_if(solution.inputs, [&](RecordedInput const& input) {
            return input.kind == PlayerInput::Kind::cut && isPair(input.object, input.other);
        });
        bool const laid = std::any_of(solution.wires.begin(), solution.wires.end(),
                                      [&](LevelConnection const& wire) { return isPair(wire.a, wire.b); });
        if (!laid) {
            solution.wires.push_back({a, b, "", {}});
        }
    }
    return {std::move(solution), {}};
}

IfClosed ifClosedIn(GoalRun const& run) {
    return run.deviceWasOn && run.nearer ? run.shown() : IfClosed::unknown;
}

std::vector<Miss*> gapsIn(std::vector<Miss>& besides) {
    std::vector<Miss*> gaps;
    for (Miss& miss : besides) {
        if (miss.lack == Lack::gap && (miss.frame == 0 || miss.atBest)) { // else it is about what had held
            gaps.push_back(&miss);
        }
    }
    return gaps;
}

std::vector<Suspect> suspectsOf(LevelRuns const& runs, Solution const& solution, AskOptions const& options,
                                Miss const& nearest) {
    std::set<std::string> known;
    for (Miss const& other : nearest.besides) {
        known.insert(other.names.begin(), other.names.end());
    }
    SuspectFinder finder(nearest.names.front(), nearest.frame, known);
    std::vector<Suspect> suspects;
    RunObserver observer;
    observer.frame = [&](LevelRun const& run) {
        return !(options.stop && options.stop()) && finder.look(run.world());
    };
    observer.end = [&](LevelRun const& run) { suspects = finder.suspects(run.world()); };
    (void)runs.run({solution}, {.frames = options.frames, .stopWhenSolved = true, .trace = false}, observer);
    return suspects;
}

/// What is told of a suspect: who stood in whose way, and the circuit of the device, which is the reason.
void tell(Suspect const& suspect, Miss& nearest) {
    for (Barrier const& barrier : suspect.barriers) {
        nearest.besides.push_back(missOfBlocked(barrier.by, barrier.blocked));
    }
    nearest.besides.push_back(suspect.miss);
}

} // namespace
} // namespace held_back

void addHeldBack(LevelRuns const& runs, Solution const& solution, AskOptions const& options, Answer& answer) {
    if (!answer.nearest || answer.nearest->nearest.names.empty()) {
        return;
    }
    Miss& nearest = answer.nearest->nearest;
    GoalRuns again(runs, answer.nearest->id, nearest.measure, options, answer);
    for (Miss* const gap : held_back::gapsIn(nearest.besides)) {
        std::vector<GoalRun> const closed =
            again.run({held_back::closing(solution, *gap)}, {.device = gap->names.front()});
        gap->ifClosed = closed.empty() ? IfClosed::unknown : held_back::ifClosedIn(closed.front());
    }
    if (nearest.lack != Lack::distance || !answer.complete) {
        return;
    }
    ++answer.runs;
    std::optional<std::size_t> fewest;
    for (held_back::Suspect& suspect : held_back::suspectsOf(runs, solution, options, nearest)) {
        if (fewest && suspect.barriers.size() > *fewest) {
            break;
        }
        std::vector<Variation> variations{held_back::closing(solution, suspect.miss)};
        for (held_back::Barrier const& barrier : suspect.barriers) {
            variations.push_back({solution, barrier.touches});
        }
        std::vector<GoalRun> const tested = again.run(variations, {.device = suspect.miss.names.front()});
        if (tested.empty()) {
            return; // stopped
        }
        suspect.miss.ifClosed = held_back::ifClosedIn(tested.front());
        bool const inTheWay =
            std::all_of(tested.begin(), tested.end(), [](GoalRun const& one) { return one.nearer; });
        if (inTheWay && suspect.miss.ifClosed != IfClosed::unknown) {
            held_back::tell(suspect, nearest);
            fewest = suspect.barriers.size();
        }
    }
}

} // namespace trembler::insight
