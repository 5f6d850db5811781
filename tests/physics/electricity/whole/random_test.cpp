// Random circuits under random sequences of connections, disconnections, creation and destruction, in a real
// world, compared with a reference without blocks and incremental updates.
#include "tests/physics/electricity/oracle.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>

namespace trembler::test {
namespace random_test {
namespace {

using Line = Script::Line;

// Uniformly from [0, bound), independent of the test's size, unlike RapidCheck's ranges.
int below(int bound) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, bound));
}

bool chance(int outOfTen) {
    return below(10) < outOfTen;
}

/// A world and the oracle's model of it, driven by random numbers.
class RandomCircuit {
public:
    RandomCircuit(std::string const& level, bool networks, int threads = 1)
        : circuit_({.threads = threads, .detail = {{"electricity", level}}, .periods = {}, .trace = false}),
          networks_(networks) {
        int const count = 2 + below(11);
        for (int i = 0; i < count; ++i) {
            Oracle::Part const part = randomPart();
            ObjectId const id = circuit_.conductor("object " + std::to_string(i), part.network);
            give(id, part);
        }
        insulator_ = circuit_.store().create("wood");
        prepareBirths();
        circuit_.start();
    }

    [[nodiscard]] CircuitWorld& circuit() { return circuit_; }
    [[nodiscard]] Oracle const& oracle() const { return oracle_; }

    /// One frame: the calls of the last frame are executed, and new calls are made.
    void frame() {
        std::vector<Line> lines;
        int const calls = below(6);
        for (int i = 0; i < calls; ++i) {
            lines.push_back({someObject(), someObject(), static_cast<std::size_t>(below(3)), chance(7)});
        }
        std::vector<ObjectId> destroys;
        if (!oracle_.parts.empty() && chance(1)) {
            destroys.push_back(someObject());
        }
        std::vector<CreateObject> creates;
        if (chance(1)) {
            creates.push_back({.prototype = static_cast<std::uint32_t>(below(4)),
                               .position = {},
                               .angle = 0,
                               .velocity = {},
                               .spin = 0,
                               .maker = insulator_,
                               .number = births_++});
        }
        circuit_.write(lines, destroys, creates);
        circuit_.world().step();
        account();
        lines_ = std::move(lines);
        destroys_ = std::move(destroys);
        born_ = std::move(creates);
    }

private:
    Oracle::Part randomPart() {
        std::vector<std::string> const names =
            networks_ ? std::vector<std::string>{"", "mains", "battery"} : std::vector<std::string>{""};
        Oracle::Part part;
        if (chance(3)) {
            part.network = names[static_cast<std::size_t>(below(static_cast<int>(names.size())))];
        }
        if (chance(3)) {
            part.source = names[static_cast<std::size_t>(below(static_cast<int>(names.size())))];
        }
        if (chance(3)) {
            part.returning = names[static_cast<std::size_t>(below(static_cast<int>(names.size())))];
        }
        return part;
    }
    void give(ObjectId id, Oracle::Part const& part) {
        if (part.source) {
            circuit_.store().column<ElectricalSource>().set(id, {*part.source});
        }
        if (part.returning) {
            circuit_.store().column<ElectricalReturn>().set(id, {*part.returning});
        }
        oracle_.parts[id] = part;
    }
    void prepareBirths() {
        for (int i = 0; i < 4; ++i) {
            Oracle::Part const part = randomPart();
            Prototype prototype{"part " + std::to_string(i), {}};
            prototype.values.push_back(std::make_unique<ValueOf<Conductor>>(Conductor{part.network}));
            if (part.source) {
                prototype.values.push_back(
                    std::make_unique<ValueOf<ElectricalSource>>(ElectricalSource{*part.source}));
            }
            if (part.returning) {
                prototype.values.push_back(
                    std::make_unique<ValueOf<ElectricalReturn>>(ElectricalReturn{*part.returning}));
            }
            circuit_.store().prototypes().add(std::move(prototype));
            newParts_.push_back(part);
        }
    }
    ObjectId someObject() {
        if (oracle_.parts.empty() || chance(1)) {
            return insulator_;
        }
        return std::next(oracle_.parts.begin(), below(static_cast<int>(oracle_.parts.size())))->first;
    }
    // Brings the oracle up to date: deaths, births, then calls, as the resolvers run.
    void account() {
        for (ObjectId const id : destroys_) {
            if (id == insulator_) { // another insulator is needed
                continue;
            }
            oracle_.destroy(id);
        }
        PopulationChanges const& changes = *circuit_.world().find<PopulationChanges>();
        RC_ASSERT(changes.created.size() == born_.size());
        for (std::size_t i = 0; i < born_.size(); ++i) {
            oracle_.parts[changes.created[i]] = newParts_[born_[i].prototype];
        }
        oracle_.carryOut(lines_);
    }

    CircuitWorld circuit_;
    bool networks_;
    Oracle oracle_;
    ObjectId insulator_;
    std::vector<Oracle::Part> newParts_;
    std::uint64_t births_ = 0;
    std::vector<Line> lines_; // calls of the last frame
    std::vector<ObjectId> destroys_;
    std::vector<CreateObject> born_;
};

void checkGraph(CircuitWorld& circuit, Oracle const& oracle) {
    auto const& graph = circuit.store().column<ElectricityGraph>();
    RC_ASSERT(graph.size() == oracle.parts.size());
    std::size_t connections = 0;
    for (std::size_t r = 0; r < graph.size(); ++r) {
        ObjectId const a = graph.owners()[r];
        RC_ASSERT(oracle.parts.contains(a));
        auto const& row = graph.values()[r].connections;
        for (std::size_t i = 0; i < row.size(); ++i) {
            RC_ASSERT((i == 0 || row[i - 1].to < row[i].to)); // RapidCheck would evaluate both
            RC_ASSERT(row[i].counts.any());
            RC_ASSERT(connectionBetween(circuit.store(), row[i].to, a) == row[i].counts); // symmetric
            ++connections;
        }
    }
    std::size_t expected = 0;
    for (auto const& [pair, counts] : oracle.counts) {
        CallerCounts const found = connectionBetween(circuit.store(), pair.first, pair.second);
        for (std::size_t script = 0; script < scripts; ++script) {
            RC_ASSERT(countBy(found, script) == counts[script]);
        }
        expected += oracle.connected(pair.first, pair.second) ? 2 : 0;
    }
    RC_ASSERT(connections == expected);
}

/// Checks that exactly the objects in `expected` are on, and that the switched ones since `before` are
/// correct.
void checkState(CircuitWorld& circuit, Oracle const& oracle, std::set<ObjectId> const& expected,
                std::set<ObjectId>& before) {
    auto const* const state = circuit.world().find<ElectricalState>();
    if (oracle.parts.empty()) {
        RC_ASSERT((state == nullptr || std::none_of(state->byIndex.begin(), state->byIndex.end(),
                                                    [](auto const& entry) { return entry.object.valid(); })));
        before.clear();
        return;
    }
    std::set<ObjectId> on;
    std::set<ObjectId> known;
    for (std::size_t i = 0; i < state->byIndex.size(); ++i) {
        if (ObjectId const id = state->byIndex[i].object; id.valid()) {
            RC_ASSERT(id.index == i);
            known.insert(id);
            if (state->byIndex[i].on) {
                on.insert(id);
            }
        }
    }
    std::set<ObjectId> conductors;
    for (auto const& [id, part] : oracle.parts) {
        conductors.insert(id);
    }
    RC_ASSERT(known == conductors);
    RC_ASSERT(on == expected);
    std::vector<ObjectId> switchedOn;
    std::vector<ObjectId> switchedOff;
    std::set_difference(on.begin(), on.end(), before.begin(), before.end(), std::back_inserter(switchedOn));
    std::set_difference(before.begin(), before.end(), on.begin(), on.end(), std::back_inserter(switchedOff));
    std::erase_if(switchedOff, [&](ObjectId id) { return !oracle.parts.contains(id); });
    bool const news = state->frame == circuit.world().frame();
    RC_ASSERT((news ? state->switchedOn : std::vector<ObjectId>{}) == switchedOn);
    RC_ASSERT((news ? state->switchedOff : std::vector<ObjectId>{}) == switchedOff);
    before = std::move(on);
}

TEST(ElectricityRandom, TwoWireIsTwoDisjointPaths) {
    EXPECT_TRUE(rc::check("two-wire against flow", [] {
        RandomCircuit random("two-wire", false);
        std::set<ObjectId> before;
        for (int frame = 0; frame < 40; ++frame) {
            random.frame();
            checkGraph(random.circuit(), random.oracle());
            checkState(random.circuit(), random.oracle(), random.oracle().onByTwoWire(), before);
        }
    }));
}

TEST(ElectricityRandom, TwoWireInSeveralNetworks) {
    EXPECT_TRUE(rc::check("two-wire against flow, by network", [] {
        RandomCircuit random("two-wire", true);
        std::set<ObjectId> before;
        for (int frame = 0; frame < 40; ++frame) {
            random.frame();
            checkState(random.circuit(), random.oracle(), random.oracle().onByTwoWire(), before);
        }
    }));
}

TEST(ElectricityRandom, SingleCableIsFloodFill) {
    EXPECT_TRUE(rc::check("single-cable against disjoint sets", [] {
        RandomCircuit random("single-cable", *rc::gen::arbitrary<bool>());
        std::set<ObjectId> before;
        for (int frame = 0; frame < 40; ++frame) {
            random.frame();
            checkGraph(random.circuit(), random.oracle());
            checkState(random.circuit(), random.oracle(), random.oracle().onBySingleCable(), before);
        }
    }));
}

TEST(ElectricityRandom, DetailLevelsSwapAtAnyTime) {
    EXPECT_TRUE(rc::check("swapped levels are as if never swapped", [] {
        RandomCircuit random("two-wire", true);
        std::set<ObjectId> before;
        bool twoWire = true;
        for (int frame = 0; frame < 40; ++frame) {
            if (chance(3)) {
                twoWire = !twoWire;
                random.circuit().world().setDetail("electricity", twoWire ? "two-wire" : "single-cable");
            }
            random.frame();
            checkState(random.circuit(), random.oracle(),
                       twoWire ? random.oracle().onByTwoWire() : random.oracle().onBySingleCable(), before);
        }
    }));
}

TEST(ElectricityRandom, APeriodDelaysTheStateButLosesNothing) {
    EXPECT_TRUE(rc::check("every third frame", [] {
        RandomCircuit random("two-wire", false);
        random.circuit().world().setPeriod("Two-wire Electricity", 3);
        std::set<ObjectId> before;
        for (int frame = 1; frame <= 40; ++frame) {
            random.frame();
            if ((frame - 1) % 3 == 0) {
                checkState(random.circuit(), random.oracle(), random.oracle().onByTwoWire(), before);
            }
        }
    }));
}

} // namespace
} // namespace random_test
} // namespace trembler::test
