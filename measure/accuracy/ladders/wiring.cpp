#include "measure/accuracy/ladders/wiring.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace trembler::accuracy {

std::uint32_t Wiring::add(Part part, double ohm) {
    parts.push_back(part);
    ohms.push_back(ohm);
    return static_cast<std::uint32_t>(parts.size() - 1);
}

void Wiring::cable(std::uint32_t a, std::uint32_t b) {
    std::pair<std::uint32_t, std::uint32_t> const one{std::min(a, b), std::max(a, b)};
    if (a != b && std::find(cables.begin(), cables.end(), one) == cables.end()) {
        cables.push_back(one);
    }
}

namespace {

// Solves a x = b in place; the unknown of an empty row becomes zero.
std::vector<double> solve(std::vector<std::vector<double>> a, std::vector<double> b) {
    std::size_t const n = b.size();
    for (std::size_t column = 0; column < n; ++column) {
        std::size_t pivot = column;
        for (std::size_t row = column + 1; row < n; ++row) {
            pivot = std::abs(a[row][column]) > std::abs(a[pivot][column]) ? row : pivot;
        }
        if (std::abs(a[pivot][column]) < 1e-12) {
            continue;
        }
        std::swap(a[pivot], a[column]);
        std::swap(b[pivot], b[column]);
        for (std::size_t row = 0; row < n; ++row) {
            if (row != column && a[row][column] != 0) {
                double const factor = a[row][column] / a[column][column];
                for (std::size_t k = column; k < n; ++k) {
                    a[row][k] -= factor * a[column][k];
                }
                b[row] -= factor * b[column];
            }
        }
    }
    std::vector<double> x(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
        x[i] = std::abs(a[i][i]) < 1e-12 ? 0 : b[i] / a[i][i];
    }
    return x;
}

} // namespace

std::vector<double> potentials(Wiring const& wiring) {
    std::size_t const n = wiring.parts.size();
    std::vector<std::vector<double>> conductance(n, std::vector<double>(n, 0));
    std::vector<double> current(n, 0);
    for (auto const& [a, b] : wiring.cables) {
        double const g = 2 / (wiring.ohms[a] + wiring.ohms[b]);
        conductance[a][a] += g;
        conductance[b][b] += g;
        conductance[a][b] -= g;
        conductance[b][a] -= g;
    }
    for (std::size_t i = 0; i < n; ++i) {
        if (wiring.parts[i] == Part::source || wiring.parts[i] == Part::earth) {
            bool const drives = wiring.parts[i] == Part::source;
            double const g = 1 / (wiring.ohms[i] / 2 + (drives ? sourceOhms : 0));
            conductance[i][i] += g;
            current[i] += drives ? g * sourceVolts : 0;
        }
    }
    return solve(conductance, current);
}

namespace {

// Calls f(the cable's ends, current through it in A) for every cable.
template <class F>
void forCables(Wiring const& wiring, std::vector<double> const& volts, F&& f) {
    for (auto const& [a, b] : wiring.cables) {
        f(a, b, 2 * std::abs(volts[a] - volts[b]) / (wiring.ohms[a] + wiring.ohms[b]));
    }
}

} // namespace

std::vector<double> currents(Wiring const& wiring, std::vector<double> const& volts) {
    std::vector<double> amperes(wiring.parts.size(), 0);
    forCables(wiring, volts, [&](std::uint32_t a, std::uint32_t b, double through) {
        amperes[a] += through / 2;
        amperes[b] += through / 2;
    });
    return amperes;
}

std::vector<bool> glowing(Wiring const& wiring) {
    std::vector<double> watts(wiring.parts.size(), 0);
    forCables(wiring, potentials(wiring), [&](std::uint32_t a, std::uint32_t b, double amperes) {
        watts[a] += amperes * amperes * wiring.ohms[a] / 2;
        watts[b] += amperes * amperes * wiring.ohms[b] / 2;
    });
    std::vector<bool> result(watts.size(), false);
    for (std::size_t i = 0; i < watts.size(); ++i) {
        result[i] = wiring.parts[i] == Part::lamp && watts[i] >= leastGlow * lampWatts;
    }
    return result;
}

std::vector<Wiring> schoolbook(int count) {
    std::vector<Wiring> all;
    for (int i = 0; i < count; ++i) {
        Wiring w;
        std::uint32_t const plus = w.add(Part::source, wireOhms);
        std::uint32_t const minus = w.add(Part::earth, wireOhms);
        auto const lamp = [&] { return w.add(Part::lamp, lampOhms); };
        switch (i % 6) {
        case 0: // a bridge: four arms, a lamp across; every other bridge is balanced
        case 3: {
            std::uint32_t const a = lamp();
            std::uint32_t const b = lamp();
            std::uint32_t const c = lamp();
            std::uint32_t const left = w.add(Part::wire, wireOhms);
            std::uint32_t const right = w.add(Part::wire, wireOhms);
            std::uint32_t const across = lamp();
            for (std::uint32_t const arm : {a, b}) {
                w.cable(plus, arm);
            }
            w.cable(a, left);
            w.cable(b, right);
            w.cable(left, across);
            w.cable(across, right);
            w.cable(left, c);
            w.cable(c, minus);
            std::uint32_t const last = i % 6 == 0 ? lamp() : w.add(Part::wire, wireOhms);
            w.cable(right, last);
            w.cable(last, minus);
            break;
        }
        case 1: { // a wire across the middle lamp of three in series
            std::uint32_t const a = lamp();
            std::uint32_t const b = lamp();
            std::uint32_t const c = lamp();
            std::uint32_t const before = w.add(Part::wire, wireOhms);
            std::uint32_t const after = w.add(Part::wire, wireOhms);
            w.cable(plus, a);
            w.cable(a, before);
            w.cable(before, b);
            w.cable(b, after);
            w.cable(after, c);
            w.cable(c, minus);
            w.cable(before, after);
            break;
        }
        case 2: { // two to thirteen lamps in series: the more, the dimmer
            std::uint32_t before = plus;
            for (int k = 0; k < 2 + i % 12; ++k) {
                std::uint32_t const next = lamp();
                w.cable(before, next);
                before = next;
            }
            w.cable(before, minus);
            break;
        }
        case 4: { // lamps in parallel, and a dead end
            for (int k = 0; k < 3; ++k) {
                std::uint32_t const one = lamp();
                w.cable(plus, one);
                w.cable(one, minus);
            }
            w.cable(plus, lamp());
            break;
        }
        default: { // a loop of lamps connected to the source only, and one lamp that glows
            std::uint32_t const a = lamp();
            std::uint32_t const b = lamp();
            std::uint32_t const works = lamp();
            w.cable(plus, a);
            w.cable(a, b);
            w.cable(b, plus);
            w.cable(plus, works);
            w.cable(works, minus);
            break;
        }
        }
        all.push_back(std::move(w));
    }
    return all;
}

std::vector<Wiring> jumble(int count, int parts) {
    std::mt19937 random(20);
    std::vector<Wiring> all;
    for (int i = 0; i < count; ++i) {
        Wiring w;
        w.add(Part::source, wireOhms);
        w.add(Part::earth, wireOhms);
        for (int k = 2; k < parts; ++k) {
            bool const isLamp = random() % 2 == 0;
            std::uint32_t const part = isLamp ? w.add(Part::lamp, lampOhms) : w.add(Part::wire, wireOhms);
            w.cable(part, static_cast<std::uint32_t>(random() % part));
        }
        for (int k = 0; k < parts / 3; ++k) {
            auto const n = static_cast<std::uint32_t>(parts);
            w.cable(static_cast<std::uint32_t>(random() % n), static_cast<std::uint32_t>(random() % n));
        }
        std::erase(w.cables, std::pair<std::uint32_t, std::uint32_t>{0, 1}); // no short circuits
        all.push_back(std::move(w));
    }
    return all;
}

} // namespace trembler::accuracy
