// The wires that the player lays while building.
#include "puzzle/session/session.hpp"
#include "runtime/level/json/add_problem.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {

Verdict Session::checkWire(ObjectId a, ObjectId b) const {
    LastingObject const one = lasting(a);
    LastingObject const other = lasting(b);
    if (!nameOf(one, level_, placed()) || !nameOf(other, level_, placed())) {
        return {false, "A wire goes from one object to another."};
    }
    if (one == other) {
        return {false, "A wire needs another object at its other end."};
    }
    if (wiresLeft() <= 0) {
        return {false, "There is no wire left in the toolbox."};
    }
    bool const laid = std::any_of(wires().begin(), wires().end(),
                                  [&](LaidWire const& wire) { return wire.connects(one, other); });
    std::string const& nameA = world().store().nameOf(a);
    std::string const& nameB = world().store().nameOf(b);
    bool const given =
        std::any_of(level_.connections.begin(), level_.connections.end(), [&](LevelConnection const& wire) {
            return (wire.a == nameA && wire.b == nameB) || (wire.a == nameB && wire.b == nameA);
        });
    if (laid || given) {
        return {false, "There is a wire between them already."};
    }
    for (Connector const& connector : registry_.connectors()) {
        if (connector.kind == playersWire) {
            auto const why = connector.refusal(world().store(), a, b);
            return why ? Verdict{false, *why} : Verdict{};
        }
    }
    return {false, "There is no electricity in this program."};
}

bool Session::layWire(ObjectId a, ObjectId b) {
    if (!building() || !checkWire(a, b).ok) {
        return false;
    }
    std::vector<LaidWire> next = wires();
    next.push_back({lasting(a), lasting(b)});
    return keep(placed(), std::move(next));
}

bool Session::takeWire(ObjectId a, ObjectId b) {
    LastingObject const one = lasting(a);
    LastingObject const other = lasting(b);
    std::vector<LaidWire> next = wires();
    bool const found =
        std::erase_if(next, [&](LaidWire const& wire) { return wire.connects(one, other); }) > 0;
    return building() && found && keep(placed(), std::move(next));
}

std::vector<LaidWire> Session::wiresOf(Solution const& solution, Placements::List const& placements) const {
    std::vector<LaidWire> laid;
    Problems problems;
    auto const refuse = [&](LevelConnection const& wire, std::string const& why, char const* expected) {
        addProblem(problems, [&] { return level_.diagnostic(solution, wire.path, why, expected); });
    };
    for (LevelConnection const& wire : solution.wires) {
        auto const a = objectNamed(wire.a, level_, placements);
        auto const b = objectNamed(wire.b, level_, placements);
        if (!a || !b) {
            refuse(wire, fmt::format("there is no object '{}'", a ? wire.b : wire.a),
                   "an object of the level, or one that the solution places");
        } else if (laid.size() >= static_cast<std::size_t>(level_.wires)) {
            refuse(wire, fmt::format("the toolbox of this level has {} wires", level_.wires),
                   "wires that the level allows");
        } else {
            laid.push_back({*a, *b});
        }
    }
    problems.throwIfAny();
    return laid;
}

} // namespace trembler
