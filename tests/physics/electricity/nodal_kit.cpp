#include "tests/physics/electricity/nodal_kit.hpp"

#include <cmath>
#include <numeric>

namespace trembler::test {
namespace {

WorldOptions optionsFor(std::string const& level, int threads, bool trace) {
    WorldOptions options{.threads = threads, .detail = {}, .periods = {}, .trace = trace};
    if (!level.empty()) {
        options.detail["electricity"] = level;
    }
    return options;
}

} // namespace

NodalWorld::NodalWorld(std::string const& level, int threads, bool trace)
    : CircuitWorld(optionsFor(level, threads, trace)) {}

ObjectId NodalWorld::resistor(std::string const& name, double ohm) {
    ObjectId const id = conductor(name);
    store().column<Resistance>().set(id, {ohm});
    return id;
}

ObjectId NodalWorld::lamp(std::string const& name, double volt, double watt) {
    ObjectId const id = conductor(name);
    store().column<RatedPower>().set(id, {watt, volt});
    return id;
}

ObjectId NodalWorld::fuse(std::string const& name, double ampere) {
    ObjectId const id = conductor(name);
    store().column<Fuse>().set(id, {ampere, false});
    return id;
}

ObjectId NodalWorld::battery(std::string const& name, double volt, double internalOhm,
                             std::string const& network) {
    ObjectId const id = source(name, network);
    store().column<Emf>().set(id, {volt, internalOhm});
    return id;
}

void NodalWorld::begin() {
    start();
    world().step();
}

ElectricalQuantities const& NodalWorld::quantities() {
    return *world().find<ElectricalQuantities>();
}

ElectricalQuantities::Entry NodalWorld::at(std::string const& name) {
    auto const* const entry = quantities().find((*this)[name]);
    return entry == nullptr ? ElectricalQuantities::Entry{} : *entry;
}

ElectricalQuantities::Circuit NodalWorld::circuitOf(std::string const& name) {
    auto const* const circuit = quantities().circuitOf((*this)[name]);
    return circuit == nullptr ? ElectricalQuantities::Circuit{} : *circuit;
}

Tableau solveTableau(Netlist const& netlist, long double idealOhm) {
    std::size_t const nodes = netlist.objects.size();
    std::size_t const size = nodes + netlist.branches.size();
    std::vector<std::vector<long double>> rows(size, std::vector<long double>(size + 1, 0));
    for (std::size_t b = 0; b < netlist.branches.size(); ++b) {
        Netlist::Branch const& branch = netlist.branches[b];
        auto& law = rows[nodes + b]; // V_from - V_to - R i = -emf
        if (branch.from < nodes) {
            rows[branch.from][nodes + b] -= 1;
            law[branch.from] += 1;
        }
        if (branch.to < nodes) {
            rows[branch.to][nodes + b] += 1;
            law[branch.to] -= 1;
        }
        law[nodes + b] = branch.resistance == 0 ? -idealOhm : -static_cast<long double>(branch.resistance);
        law[size] = -static_cast<long double>(branch.emf);
    }
    for (auto& row : rows) { // so that pivots compare
        long double largest = 0;
        for (std::size_t c = 0; c < size; ++c) {
            largest = std::max(largest, std::abs(row[c]));
        }
        for (long double& value : row) {
            value /= largest == 0 ? 1 : largest;
        }
    }
    std::vector<std::size_t> columns(size);
    std::iota(columns.begin(), columns.end(), std::size_t{0});
    std::size_t rank = 0;
    for (; rank < size; ++rank) {
        std::size_t row = rank;
        std::size_t column = rank;
        for (std::size_t r = rank; r < size; ++r) {
            for (std::size_t c = rank; c < size; ++c) {
                if (std::abs(rows[r][columns[c]]) > std::abs(rows[row][columns[column]])) {
                    row = r;
                    column = c;
                }
            }
        }
        if (std::abs(rows[row][columns[column]]) < 1e-17L) {
            break;
        }
        std::swap(rows[rank], rows[row]);
        std::swap(columns[rank], columns[column]);
        for (std::size_t r = rank + 1; r < size; ++r) {
            long double const factor = rows[r][columns[rank]] / rows[rank][columns[rank]];
            if (factor != 0) {
                for (std::size_t c = rank; c < size; ++c) {
                    rows[r][columns[c]] -= factor * rows[rank][columns[c]];
                }
                rows[r][size] -= factor * rows[rank][size];
            }
        }
    }
    std::vector<long double> found(size, 0);
    for (std::size_t k = rank; k-- > 0;) {
        long double sum = rows[k][size];
        for (std::size_t c = k + 1; c < rank; ++c) {
            sum -= rows[k][columns[c]] * found[columns[c]];
        }
        found[columns[k]] = sum / rows[k][columns[k]];
    }
    Tableau tableau;
    tableau.potentials.assign(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(nodes));
    tableau.currents.assign(found.begin() + static_cast<std::ptrdiff_t>(nodes), found.end());
    return tableau;
}

Netlist withoutIdealLoops(Netlist const& netlist) {
    Netlist without = netlist;
    without.branches.clear();
    std::vector<std::uint32_t> set(netlist.objects.size() + 1);
    std::iota(set.begin(), set.end(), 0U);
    for (Netlist::Branch const& branch : netlist.branches) {
        if (branch.resistance == 0) {
            std::uint32_t const from = set[branch.from];
            std::uint32_t const to = set[branch.to];
            if (from == to) {
                continue;
            }
            std::replace(set.begin(), set.end(), from, to);
        }
        without.branches.push_back(branch);
    }
    return without;
}

std::vector<std::string> NodalWorld::events() {
    std::vector<std::string> names;
    if (Tracer const* const tracer = world().tracer()) {
        for (Event const& event : tracer->events()) {
            names.push_back(event.event);
        }
    }
    return names;
}

} // namespace trembler::test
