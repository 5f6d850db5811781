// The cost of one changed connection: Trembler's resolver and detail level, which update only the changed
// circuit, compared with the Boost Graph Library on the whole graph. In a city of 1e5 electrical objects in
// 2,000 separate buildings, and on one chain of 1e6 objects, where locality gains nothing.
#include "physics/electricity/calls.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/register.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/world/world.hpp"
#include "tests/support/initial_wire.hpp"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/biconnected_components.hpp>
#include <boost/graph/connected_components.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace trembler;

using Edges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// A wiring plan. Objects are numbered from 0.
struct Plan {
    std::uint32_t objects = 0;
    std::vector<std::uint32_t> sources;
    std::vector<std::uint32_t> returns;
    Edges wires;
};

/// Buildings of equal size with a source and a return each; the wiring is a tree with a fifth more wires, as
/// in houses.
Plan city(std::uint32_t buildings, std::uint32_t perBuilding) {
    Plan plan;
    std::mt19937 random(42);
    for (std::uint32_t building = 0; building < buildings; ++building) {
        std::uint32_t const first = building * perBuilding;
        plan.sources.push_back(first);
        plan.returns.push_back(first + perBuilding - 1);
        for (std::uint32_t i = 1; i < perBuilding; ++i) {
            plan.wires.emplace_back(first + static_cast<std::uint32_t>(random() % i), first + i);
        }
        for (std::uint32_t i = 0; i < perBuilding / 5; ++i) {
            auto const a = static_cast<std::uint32_t>(random() % (perBuilding - 1));
            auto const b = a + 1 + static_cast<std::uint32_t>(random() % (perBuilding - 1 - a));
            plan.wires.emplace_back(first + a, first + b);
        }
    }
    plan.objects = buildings * perBuilding;
    std::sort(plan.wires.begin(), plan.wires.end());
    plan.wires.erase(std::unique(plan.wires.begin(), plan.wires.end()), plan.wires.end());
    return plan;
}

Plan chain(std::uint32_t objects) {
    Plan plan;
    plan.objects = objects;
    plan.sources = {0};
    plan.returns = {objects - 1};
    for (std::uint32_t i = 1; i < objects; ++i) {
        plan.wires.emplace_back(i - 1, i);
    }
    return plan;
}

/// The change to be made in the next frame.
struct Change {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Change", "bench_change", "A connection to add or to remove.",
                                       PropertyPlace::hidden};
    ObjectId a;
    ObjectId b;
    bool add = true;
};

class ElectricityFromBench final : public Interaction<ElectricityFromBench, ElectricityRole, Reads<Change>> {
public:
    static constexpr ComponentText text{
        .name = "Electricity <- Bench", .effect = "bench", .level = "", .work = "Makes the change."};
    using Activation = NeedsAll<Change>;
    void apply(Access& access) {
        for (Change const& change : access.read<Change>().values()) {
            if (change.add) {
                access.call(AddConnection{{change.a, change.b}});
            } else {
                access.call(CutWire{change.a, change.b}); // the original cable, or the one that repaired it
                access.call(RemoveConnection{{change.a, change.b}});
            }
        }
    }
};

double microsecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
}

class TremblerSide {
public:
    TremblerSide(Plan const& plan, std::string const& level) {
        registerRuntime(registry_);
        registerElectricity(registry_);
        registry_.component<ElectricityFromBench>();
        world_ = std::make_unique<World>(
            registry_,
            WorldOptions{.threads = 1, .detail = {{"electricity", level}}, .periods = {}, .trace = false});
        Store& store = world_->store();
        for (std::uint32_t i = 0; i < plan.objects; ++i) {
            objects_.push_back(store.create(std::to_string(i)));
            store.column<Conductor>().set(objects_.back(), {});
        }
        for (std::uint32_t const i : plan.sources) {
            store.column<ElectricalSource>().set(objects_[i], {});
        }
        for (std::uint32_t const i : plan.returns) {
            store.column<ElectricalReturn>().set(objects_[i], {});
        }
        for (auto const& [a, b] : plan.wires) {
            if (auto const wrong = connectInitially(store, objects_[a], objects_[b])) {
                throw std::logic_error(*wrong);
            }
        }
        director_ = store.create("director");
        store.column<Change>().set(director_, {});
        world_->start();
        step(2);
    }
    /// Both frames that a change takes, with everything computed in them.
    double change(std::pair<std::uint32_t, std::uint32_t> wire, bool add) {
        Change const change{objects_[wire.first], objects_[wire.second], add};
        auto const start = std::chrono::steady_clock::now();
        world_->store().column<Change>().set(director_, change);
        step(2);
        return microsecondsSince(start);
    }
    [[nodiscard]] bool isOn(std::uint32_t i) const {
        return world_->find<ElectricalState>()->isOn(objects_[i]);
    }

private:
    void step(int frames) {
        for (int i = 0; i < frames; ++i) {
            world_->step();
        }
    }
    Registry registry_;
    std::unique_ptr<World> world_;
    std::vector<ObjectId> objects_;
    ObjectId director_;
};

/// The Boost Graph Library on the whole graph. The graph is kept between changes; only the analysis starts
/// from scratch.
class WholeGraph {
public:
    WholeGraph(Plan const& plan, bool twoWire)
        : twoWire_(twoWire), graph_(plan.objects + 2), on_(plan.objects) {
        add_edge(source, returning, graph_);
        for (std::uint32_t const i : plan.sources) {
            add_edge(source, i + 2, graph_);
        }
        for (std::uint32_t const i : plan.returns) {
            add_edge(returning, i + 2, graph_);
        }
        if (!twoWire_) {
            remove_edge(source, returning, graph_);
        }
        for (auto const& [a, b] : plan.wires) {
            add_edge(a + 2, b + 2, graph_);
        }
    }
    double change(std::pair<std::uint32_t, std::uint32_t> wire, bool add) {
        auto const start = std::chrono::steady_clock::now();
        if (add) {
            add_edge(wire.first + 2, wire.second + 2, graph_);
        } else {
            remove_edge(wire.first + 2, wire.second + 2, graph_);
        }
        std::fill(on_.begin(), on_.end(), std::uint8_t{0});
        twoWire_ ? markBlock() : markComponent();
        return microsecondsSince(start);
    }
    [[nodiscard]] bool isOn(std::uint32_t i) const { return on_[i] != 0; }

private:
    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                        boost::property<boost::edge_index_t, std::size_t>>;
    static constexpr std::uint32_t source = 0;
    static constexpr std::uint32_t returning = 1;

    void markBlock() {
        // The edge property serves as the index of the block.
        auto const block = get(boost::edge_index, graph_);
        biconnected_components(graph_, block);
        std::size_t const live = get(block, edge(source, returning, graph_).first);
        for (auto [e, end] = edges(graph_); e != end; ++e) {
            if (get(block, *e) == live) {
                mark(boost::source(*e, graph_));
                mark(target(*e, graph_));
            }
        }
    }
    // The return node connects all buildings, so it is excluded from the components of cables.
    void markComponent() {
        component_.resize(num_vertices(graph_));
        clear_vertex(returning, graph_);
        connected_components(graph_, component_.data());
        for (std::size_t v = 2; v < component_.size(); ++v) {
            if (component_[v] == component_[source]) {
                mark(v);
            }
        }
    }
    void mark(std::size_t vertex) {
        if (vertex >= 2) {
            on_[vertex - 2] = 1;
        }
    }

    bool twoWire_;
    Graph graph_;
    std::vector<std::uint8_t> on_;
    std::vector<int> component_;
};

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

/// Cuts and repairs wires in different places, alternating between both sides. Returns how many times faster
/// Trembler is.
double compare(std::string const& title, Plan const& plan, std::string const& level, int rounds) {
    TremblerSide trembler(plan, level);
    WholeGraph whole(plan, level == "two-wire");
    std::mt19937 random(7);
    std::vector<double> ours;
    std::vector<double> theirs;
    std::size_t switches = 0;
    std::vector<bool> before;
    for (std::uint32_t i = 0; i < plan.objects; ++i) {
        before.push_back(trembler.isOn(i));
    }
    for (int round = 0; round < rounds; ++round) {
        auto const& wire = plan.wires[random() % plan.wires.size()];
        for (bool const add : {false, true}) {
            ours.push_back(trembler.change(wire, add));
            theirs.push_back(whole.change(wire, add));
            for (std::uint32_t i = 0; i < plan.objects; ++i) {
                if (trembler.isOn(i) != whole.isOn(i)) {
                    throw std::logic_error("the two disagree about object " + std::to_string(i));
                }
                switches += before[i] != trembler.isOn(i) ? 1U : 0U;
                before[i] = trembler.isOn(i);
            }
        }
    }
    double const ratio = median(theirs) / median(ours);
    fmt::print("{:<34} {:<13} {:>12.1f} {:>12.1f} {:>9.1f} {:>9}\n", title, level, median(ours),
               median(theirs), ratio, switches / ours.size());
    return ratio;
}

} // namespace

int main() {
    try {
        fmt::print("one changed connection, medians in us (Trembler: two whole frames; BGL: kept graph)\n");
        fmt::print("{:<34} {:<13} {:>12} {:>12} {:>9} {:>9}\n", "graph", "level", "Trembler", "all by BGL",
                   "ratio", "switches");
        Plan const town = city(2000, 50);
        double const twoWire = compare("city, 2000 buildings of 50", town, "two-wire", 40);
        double const singleCable = compare("city, 2000 buildings of 50", town, "single-cable", 40);
        Plan const line = chain(1000000);
        compare("chain of 1e6", line, "two-wire", 3);
        compare("chain of 1e6", line, "single-cable", 3);
        bool const good = twoWire >= 100 && singleCable >= 100;
        fmt::print("required in the city: 100 times faster; {}\n", good ? "met" : "NOT MET");
        return good ? 0 : 1;
    } catch (std::exception const& error) {
        fmt::print(stderr, "bench_electricity: {}\n", error.what());
        return 2;
    }
}
