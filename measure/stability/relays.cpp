// Circuits that switch themselves off: an interrupter and a ring of relays, whose contacts move without any
// mechanism in between, so that only the frame's length limits their rate.
#include "measure/stability/hard_case.hpp"
#include "physics/electricity/calls.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "puzzle/data/effects.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/property/for_each.hpp"
#include "runtime/world/registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace trembler::stability {
namespace {

/// A contact between two conductors that closes, or opens, while the object, a coil, is on.
struct Relay {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Relay", "test_relay", "A contact that a coil moves, for tests.",
                                       PropertyPlace::hidden};
    ObjectId a;
    ObjectId b;
    bool closedAtRest = false;
};

class ElectricityFromRelays final
    : public Interaction<ElectricityFromRelays, ElectricityRole, Reads<Relay, ElectricalState>> {
public:
    static constexpr ComponentText text{.name = "Electricity <- Relays",
                                        .effect = "test",
                                        .level = "",
                                        .work = "Closes and opens contacts at once."};
    using Activation = NeedsAll<Relay>;
    void hashMemory(StateHash& hash) const { hash.members(closed_); }
    void apply(Access& access) {
        auto const& state = access.read<ElectricalState>();
        forEach(
            [&](ObjectId id, Relay const& relay) {
                bool const closed = state.isOn(id) != relay.closedAtRest;
                if (closed == std::exchange(closed_[id], closed)) {
                    return;
                }
                ConnectionKey const key{relay.a, relay.b};
                if (closed) {
                    access.call(AddConnection{key});
                } else {
                    access.call(RemoveConnection{key});
                }
            },
            access.read<Relay>());
    }

private:
    std::map<ObjectId, bool> closed_;
};

Registry const& registryWithRelays() {
    static Registry const shared = [] {
        Registry made;
        registerEffects(made);
        made.component<ElectricityFromRelays>();
        return made;
    }();
    return shared;
}

/// How a level's wires are connected.
Connector const& levelWire() {
    auto const all = registryWithRelays().connectors();
    return *std::find_if(all.begin(), all.end(), [](Connector const& one) { return one.kind == "wire"; });
}

/// The behaviour of a ring of relays: each relay's contact feeds the next one's coil.
struct RelayHistory {
    std::vector<std::vector<int>> switched; // by coil, the frames in which it was switched
    std::uint64_t hash = 0;
};

RelayHistory run(std::vector<bool> const& closedAtRest, int threads, int frames) {
    World world(
        registryWithRelays(),
        WorldOptions{.threads = threads, .detail = {}, .periods = {}, .trace = false, .rowsWorthThreads = 0});
    Store& store = world.store();
    auto const conductor = [&](std::string const& name) {
        ObjectId const id = store.create(name);
        store.column<Conductor>().set(id, {});
        return id;
    };
    ObjectId const source = conductor("source");
    ObjectId const earth = conductor("earth");
    store.column<ElectricalSource>().set(source, {});
    store.column<ElectricalReturn>().set(earth, {});
    std::vector<ObjectId> coils;
    for (std::size_t i = 0; i < closedAtRest.size(); ++i) {
        coils.push_back(conductor(fmt::format("coil {}", i)));
        if (auto const wrong = levelWire().refusal(store, coils.back(), earth)) {
            throw std::logic_error(*wrong);
        }
        levelWire().lay(store, coils.back(), earth);
    }
    for (std::size_t i = 0; i < coils.size(); ++i) {
        store.column<Relay>().set(coils[i], {source, coils[(i + 1) % coils.size()], closedAtRest[i]});
    }
    Subscription const wantedElectricalState = world.want<ElectricalState>();
    world.start();
    RelayHistory course;
    course.switched.resize(coils.size());
    std::vector<bool> on(coils.size(), false);
    for (int frame = 1; frame <= frames; ++frame) {
        world.step();
        auto const& state = *world.find<ElectricalState>();
        for (std::size_t i = 0; i < coils.size(); ++i) {
            if (state.isOn(coils[i]) != on[i]) {
                on[i] = !on[i];
                course.switched[i].push_back(frame);
            }
        }
    }
    course.hash = world.stateHash();
    return course;
}

std::vector<Figure> judge(std::vector<bool> const& closedAtRest) {
    constexpr int frames = 6000;
    constexpr int lately = frames - 600;
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    RelayHistory const one = run(closedAtRest, 1, frames);
    double rate = 0;
    double stuck = 0;
    double apart = 0; // frames between switchings: longest minus shortest, of any coil, in periodic operation
    for (std::vector<int> const& switched : one.switched) {
        rate = std::max(rate, 60.0 * static_cast<double>(switched.size()) / frames);
        stuck += switched.empty() || switched.back() < lately ? 1 : 0;
        int least = frames;
        int most = 0;
        for (std::size_t i = switched.size() / 2 + 1; i < switched.size(); ++i) {
            least = std::min(least, switched[i] - switched[i - 1]);
            most = std::max(most, switched[i] - switched[i - 1]);
        }
        apart = std::max(apart, static_cast<double>(most - least));
    }
    double differ = 0;
    for (int const threads : {2, 4}) {
        RelayHistory const other = run(closedAtRest, threads, frames);
        differ += other.switched == one.switched && other.hash == one.hash ? 0 : 1;
    }
    return {{"switchings of a relay", "1/s", 60, rate},
            {"relays that stand still in the end", "", 0, stuck},
            {"unevenness", "frames", closedAtRest.size() == 1 ? 0 : unlimited, apart},
            {"thread counts that differ", "", 0, differ}};
}

} // namespace

std::vector<HardCase> relayCases() {
    return {{"interrupter without mechanical delay", "",
             [](Setting const&, std::uint64_t) { return judge({true}); }, false, true, false},
            {"50 relays in a ring", "",
             [](Setting const&, std::uint64_t seed) {
                 // With an odd number of inverting relays there is no stable state.
                 std::vector<bool> closedAtRest(50, false);
                 closedAtRest[seed % 50] = true;
                 if (seed % 2 == 0) {
                     closedAtRest[(seed + 17) % 50] = closedAtRest[(seed + 31) % 50] = true;
                 }
                 return judge(closedAtRest);
             },
             false, false}};
}

} // namespace trembler::stability
