// The wires that the player lays while building.
#include "puzzle/session/session.hpp"
#include "puzzle/session/wire_rules.hpp"
#include "runtime/level/json/add_problem.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {

Verdict Session::checkWire(ObjectId a, ObjectId b) const {
    LastingObject const one = lasting(a);
    LastingObject const other = lasting(b);
    WireEnds const ends(level_, parts_, placed());
    if (!ends.nameOf(one) || !ends.nameOf(other)) {
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
    bool const given =
        std::any_of(level_.connections.begin(), level_.connections.end(), [&](LevelConnection const& wire) {
            ObjectId const x = world().store().find(wire.a);
            ObjectId const y = world().store().find(wire.b);
            return (x == a && y == b) || (x == b && y == a);
        });
    return wireVerdict(registry_, world().store(), a, b, laid || given);
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
    WireEnds const ends(level_, parts_, placements);
    std::vector<LaidWire> laid;
    Problems problems;
    auto const refuse = [&](LevelConnection const& wire, std::string const& why, char const* expected) {
        addProblem(problems, [&] { return level_.diagnostic(solution, wire.path, why, expected); });
    };
    for (LevelConnection const& wire : solution.wires) {
        auto const a = ends.objectNamed(wire.a);
        auto const b = ends.objectNamed(wire.b);
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
