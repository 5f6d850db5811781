#include "physics/electricity/analyses/spice.hpp"

#include "physics/electricity/analyses/nodal_analysis.hpp"
#include "physics/electricity/core/sufficient_level.hpp"
#include "physics/electricity/properties/graph.hpp"
#include "runtime/world/store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace trembler {
namespace {

template <class P>
Column<P> const& columnOf(Store const& store) {
    static Column<P> const none;
    auto const* const column = store.findColumn<P>();
    return column == nullptr ? none : *column;
}

/// The text as a single line.
std::string oneLine(std::string_view text) {
    std::string line(text);
    std::replace_if(
        line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    return line;
}

class SpiceWriter {
public:
    explicit SpiceWriter(Store const& store) : store_(store) {}

    void network(Netlist const& netlist, std::string_view name) {
        NodalAnalysis analysis;
        (void)analysis.solve(netlist);
        fmt::format_to(std::back_inserter(text_), "* network '{}'\n", oneLine(name));
        std::map<std::uint32_t, std::string> nodes{{analysis.clusters()[netlist.earth()], "0"}};
        std::map<std::uint32_t, std::string> members;
        for (std::uint32_t v = 0; v < netlist.objects.size(); ++v) {
            if (analysis.floats(v)) {
                fmt::format_to(std::back_inserter(text_), "* {} floats, and is left out\n",
                               quoted(netlist, v));
                continue;
            }
            std::uint32_t const cluster = analysis.clusters()[v];
            if (!nodes.contains(cluster)) {
                nodes[cluster] = fmt::format("n{}", ++nodes_);
            }
            std::string& list = members[cluster];
            list += (list.empty() ? "" : ", ") + quoted(netlist, v);
        }
        for (auto const& [cluster, list] : members) {
            fmt::format_to(std::back_inserter(text_), "* {} = {}\n", nodes[cluster], list);
        }
        std::map<std::uint32_t, bool> pumped;
        for (std::size_t b = 0; b < netlist.branches.size(); ++b) {
            Netlist::Branch const& branch = netlist.branches[b];
            std::uint32_t const from = analysis.clusters()[branch.from];
            std::uint32_t const to = analysis.clusters()[branch.to];
            double const ohm = analysis.resistances()[b];
            if (branch.kind == Netlist::Kind::source) {
                if (ohm == 0 && (nodes[to] == "0" || std::exchange(pumped[to], true))) {
                    fmt::format_to(std::back_inserter(text_), "* source {}: like the ideal source above it\n",
                                   quoted(netlist, branch.to));
                    continue;
                }
                source(quoted(netlist, branch.to), nodes[to], branch.emf, ohm);
            } else if (analysis.floats(branch.from)) {
                continue;
            } else if (ohm != 0) {
                resistor(describe(netlist, branch), nodes[from], nodes[to], ohm);
            } else if (branch.kind == Netlist::Kind::connection) {
                fmt::format_to(std::back_inserter(text_), "* {}\n", describe(netlist, branch));
            }
        }
    }
    [[nodiscard]] std::string finish(std::string_view title) const {
        if (elements_ == 0) {
            return {};
        }
        return fmt::format(
            "* {}, as Trembler has it\n{}.control\nset numdgt=15\nop\nprint all\n.endc\n.end\n",
            oneLine(title), text_);
    }

private:
    [[nodiscard]] std::string quoted(Netlist const& netlist, std::uint32_t node) const {
        return fmt::format("'{}'", oneLine(store_.nameOf(netlist.objects[node])));
    }
    [[nodiscard]] std::string describe(Netlist const& netlist, Netlist::Branch const& branch) const {
        if (branch.kind == Netlist::Kind::returning) {
            return fmt::format("return {}", quoted(netlist, branch.from));
        }
        CallerCounts const counts =
            connectionBetween(store_, netlist.objects[branch.from], netlist.objects[branch.to]);
        return fmt::format("{} to {}, by {}", quoted(netlist, branch.from), quoted(netlist, branch.to),
                           oneLine(counts.names()));
    }
    void source(std::string const& object, std::string const& node, double emf, double ohm) {
        ++elements_;
        std::string const pole = ohm == 0 ? node : fmt::format("p{}", ++sources_);
        fmt::format_to(std::back_inserter(text_), "* v{0}: source {1}\nv{0} {2} 0 dc {3:.17g}\n", ++voltages_,
                       object, pole, emf);
        if (ohm != 0) {
            resistor(fmt::format("inside {}", object), pole, node, ohm);
        }
    }
    void resistor(std::string const& what, std::string const& from, std::string const& to, double ohm) {
        ++elements_;
        fmt::format_to(std::back_inserter(text_), "* r{0}: {1}\nr{0} {2} {3} {4:.17g}\n", ++resistors_, what,
                       from, to, ohm);
    }

    Store const& store_;
    std::string text_;
    int nodes_ = 0;
    int sources_ = 0;
    int voltages_ = 0;
    int resistors_ = 0;
    int elements_ = 0;
};

} // namespace

std::string spiceNetlist(Store const& store, std::string_view title) {
    ElectricityColumns const columns{columnOf<ElectricityGraph>(store), columnOf<Conductor>(store),
                                     columnOf<ElectricalSource>(store), columnOf<ElectricalReturn>(store)};
    NodalColumns const nodal{columnOf<Resistance>(store), columnOf<Emf>(store), columnOf<RatedPower>(store),
                             columnOf<Fuse>(store)};
    SpiceWriter writer(store);
    CircuitWalk walk;
    Circuit circuit;
    Netlist netlist;
    walk.begin(columns);
    for (ObjectId const id : columns.graph.owners()) {
        if (!walk.walk(columns, id, circuit) ||
            sufficientLevel(circuit, nodal, columns.returns).level != ElectricalLevel::nodal) {
            continue;
        }
        NetworkMembers const members(circuit);
        for (std::string_view const network : circuit.terminalNetworks()) {
            makeNetlist(circuit, nodal, network, netlist, &members);
            writer.network(netlist, network);
        }
    }
    return writer.finish(title);
}

} // namespace trembler
