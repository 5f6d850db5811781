// The gain from a second thread in a favourable scene: a hall of machines, 2,000 objects with eight effects,
// all of them active in every frame. Two worlds of the same scene, on one thread and on two, alternate frame
// by frame, so that other load on the machine affects both. For comparison, the speed-up that the schedule
// allows: the time of every component on one thread, and the longest chain of components that must run one
// after the other.
#include "audio/effect/properties/sounds.hpp"
#include "bench/measure.hpp"
#include "bench/scenes/machine_hall.hpp"
#include "physics/dynamics/properties/settings.hpp"
#include "physics/dynamics/properties/solver_choice.hpp"
#include "puzzle/data/effects.hpp"
#include "runtime/schedule/schedule.hpp"
#include "runtime/world/world.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <map>
#include <memory>
#include <set>

namespace {

using namespace trembler;

constexpr int machines = 40;
constexpr std::size_t objects = 2000;

/// How long to measure; the defaults can be changed on the command line.
struct Plan {
    int runs = 5;
    int frames = 300;
    int warmUp = 120; // frames, until all loose objects have fallen to the moving parts
    std::vector<int> substeps{4, DynamicsSettings::automatic}; // of Dynamics, one after the other
};

Registry const& effects() {
    static Registry const registry = [] {
        Registry made;
        registerEffects(made);
        return made;
    }();
    return registry;
}

struct Hall {
    std::unique_ptr<World> world;
    Subscription sounds; // requests the Sounds, as a loudspeaker does
};

Hall hall(int substeps, int threads, int listeners) {
    WorldOptions options;
    options.threads = threads;
    auto world = std::make_unique<World>(effects(), options);
    Store& store = world->store();
    bench::MachineHall(store).build(machines, objects, listeners);
    store.column<DynamicsSettings>().set(store.create("accuracy"), {.substeps = substeps});
    Subscription sounds = world->want<Sounds>();
    world->start();
    return {std::move(world), std::move(sounds)};
}

double stepTime(World& world) {
    auto const start = std::chrono::steady_clock::now();
    world.step();
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

/// The time of a component per frame, and how often it had work.
struct Share {
    ComponentInfo const* info = nullptr;
    bool present = false;
    std::vector<double> times; // µs, by frame; 0 where it was asleep
    [[nodiscard]] double mean() const {
        double sum = 0;
        for (double const time : times) {
            sum += time;
        }
        return times.empty() ? 0 : sum / static_cast<double>(times.size());
    }
    [[nodiscard]] double activity() const {
        auto const slept = std::count(times.begin(), times.end(), 0.0);
        return times.empty() ? 0 : 1 - static_cast<double>(slept) / static_cast<double>(times.size());
    }
};

/// Lower bounds for the time of a frame, µs: a phase is never shorter than its longest chain of components
/// that must follow one another, nor than half of its work on two threads.
struct Bounds {
    double all = 0;     ///< on one thread
    double whole = 0;   ///< on two, if every component were indivisible
    double divided = 0; ///< on two, if components that split their work into ranges use both
};

/// Components that split ranges of their work over threads by themselves.
bool divides(ComponentInfo const& info) {
    static std::set<std::string_view> const names{"Buoyancy", "Magnetic Forces", "Straight Loudness",
                                                  "Loudness around Corners"};
    return names.contains(info.text.name);
}

Bounds boundsOf(std::vector<ComponentStatus> const& status, std::set<std::string_view> const& inside) {
    Bounds bounds;
    for (ComponentKind const kind :
         {ComponentKind::resolver, ComponentKind::dps, ComponentKind::interaction}) {
        std::vector<ComponentInfo const*> infos;
        std::vector<double> times;
        double sum = 0;
        double shortcuts = 0;
        for (ComponentStatus const& each : status) {
            if (each.info->kind == kind && each.lastMicroseconds > 0) {
                if (inside.contains(each.info->text.name)) {
                    shortcuts += each.lastMicroseconds;
                    continue;
                }
                infos.push_back(each.info);
                times.push_back(each.lastMicroseconds);
                sum += each.lastMicroseconds;
            }
        }
        std::vector<std::pair<std::size_t, std::size_t>> edges;
        if (kind == ComponentKind::resolver) {
            edges = deriveEdges(infos);
        }
        auto const longest = [&](double shareOfDivided) {
            std::vector<double> chains(times.size(), 0);
            double most = 0;
            for (std::size_t i = 0; i < times.size(); ++i) {
                chains[i] += times[i] * (divides(*infos[i]) ? shareOfDivided : 1);
                most = std::max(most, chains[i]);
                for (auto const& [before, after] : edges) {
                    if (before == i) {
                        chains[after] = std::max(chains[after], chains[i]);
                    }
                }
            }
            return most;
        };
        // Functions inside a derived property set have no phase of their own; they are short.
        bounds.all += sum + shortcuts;
        bounds.whole += std::max(longest(1), sum / 2) + shortcuts;
        bounds.divided += std::max(longest(0.5), sum / 2) + shortcuts;
    }
    return bounds;
}

struct Run {
    bench::Series one;
    bench::Series two;
    bool same = true;
    std::vector<Share> shares;
    Bounds bounds; // means over frames
    double substeps = 0;
};

Run measure(Plan const& plan, int substeps, int listeners) {
    Hall const singleHall = hall(substeps, 1, listeners);
    Hall const twinHall = hall(substeps, 2, listeners);
    auto const& single = singleHall.world;
    auto const& twin = twinHall.world;
    std::set<std::string_view> inside;
    for (Shortcut const& shortcut : effects().shortcuts()) {
        for (Registration const& registration : effects().components()) {
            if (registration.info->type == shortcut.interaction) {
                inside.insert(registration.info->text.name);
            }
        }
    }
    Run run;
    for (ComponentStatus const& status : single->status()) {
        run.shares.push_back({status.info, status.activity != Activity::absent, {}});
    }
    for (int frame = 0; frame < plan.warmUp + plan.frames; ++frame) {
        bool const oneFirst = frame % 2 == 0;
        double const first = stepTime(oneFirst ? *single : *twin);
        double const second = stepTime(oneFirst ? *twin : *single);
        run.same = run.same && single->stateHash() == twin->stateHash();
        if (frame < plan.warmUp) {
            continue;
        }
        run.one.add(oneFirst ? first : second);
        run.two.add(oneFirst ? second : first);
        std::vector<ComponentStatus> const status = single->status();
        for (std::size_t i = 0; i < status.size(); ++i) {
            run.shares[i].times.push_back(status[i].activity == Activity::active ? status[i].lastMicroseconds
                                                                                 : 0);
        }
        run.substeps += single->find<SolverChoice>()->substeps / static_cast<double>(plan.frames);
        Bounds const bounds = boundsOf(status, inside);
        run.bounds.all += bounds.all / plan.frames;
        run.bounds.whole += bounds.whole / plan.frames;
        run.bounds.divided += bounds.divided / plan.frames;
    }
    return run;
}

void print(std::vector<Run> const& all, std::string const& name) {
    bench::Series one;
    bench::Series two;
    bench::Series gain;
    bench::Series fastOne;
    bench::Series fastTwo;
    std::string each;
    for (Run const& run : all) {
        one.add(run.one.median());
        two.add(run.two.median());
        gain.add(run.one.median() / run.two.median());
        fastOne.add(run.one.quantile(0.1));
        fastTwo.add(run.two.quantile(0.1));
        each += fmt::format(" {:.2f}", run.one.median() / run.two.median());
    }
    Run const& shown = all.back();
    std::set<std::string_view> called;
    for (Share const& share : shown.shares) {
        if (share.present && share.info->text.effect != "player" && share.info->text.effect != "population") {
            called.insert(share.info->text.effect);
        }
    }
    Bounds const& bounds = shown.bounds;
    bench::Table table(fmt::format("{}: {} machines, {} objects, called on: {}", name, machines, objects,
                                   fmt::join(called, ", ")));
    table.row("one thread", one.median(), "µs per frame");
    table.row("two threads", two.median(), "µs per frame");
    table.row("speed-up", gain.median(), fmt::format("x (runs:{})", each));
    table.row("speed-up of the fastest tenth of frames", fastOne.median() / fastTwo.median(),
              fmt::format("x ({:.0f} to {:.0f} µs)", fastOne.median(), fastTwo.median()));
    table.row("substeps of Dynamics in a frame, mean", shown.substeps, "");
    table.row("what components take, one after the other", bounds.all, "µs per frame, mean");
    table.row("speed-up that the schedule allows, components undivided", bounds.all / bounds.whole, "x");
    table.row("speed-up that it allows, ranges on both threads", bounds.all / bounds.divided, "x");
    table.print();
    std::vector<Share> shares = shown.shares;
    std::stable_sort(shares.begin(), shares.end(),
                     [](Share const& a, Share const& b) { return a.mean() > b.mean(); });
    for (Share const& share : shares) {
        if (share.mean() > 0) {
            std::printf("  %-46s %9.1f µs, active in %3.0f %%%s\n", title(*share.info).c_str(), share.mean(),
                        100 * share.activity(), divides(*share.info) ? ", in ranges" : "");
        }
    }
    std::printf("\n");
}

} // namespace

int main(int argc, char** argv) {
    Plan plan;
    for (int i = 1; i + 1 < argc; i += 2) {
        std::string const what = argv[i];
        int const number = std::max(1, std::atoi(argv[i + 1]));
        if (what == "--runs") {
            plan.runs = number;
        } else if (what == "--frames") {
            plan.frames = number;
        } else if (what == "--substeps") {
            plan.substeps = {number};
        } else if (what == "--warm-up") {
            plan.warmUp = number;
        }
    }
    bool same = true;
    for (int const substeps : plan.substeps) {
        for (auto const& [listeners, name] :
             {std::pair{0, "A hall of machines"}, std::pair{4, "The same with four microphones"}}) {
            std::vector<Run> all;
            for (int i = 0; i < plan.runs; ++i) {
                all.push_back(measure(plan, substeps, listeners));
                same = same && all.back().same;
            }
            std::string const accuracy = substeps == DynamicsSettings::automatic
                                             ? std::string("substeps as the scene needs them")
                                             : fmt::format("{} substeps", substeps);
            print(all, fmt::format("{}, {}", name, accuracy));
        }
    }
    std::printf("every frame the same, bit for bit, on one thread and on two: %s\n", same ? "yes" : "NO");
    return same ? 0 : 1;
}
