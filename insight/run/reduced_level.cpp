#include "insight/run/reduced_level.hpp"

#include "insight/run/placed_names.hpp"
#include "puzzle/data/effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string_view>

namespace trembler::insight {
namespace {

using Indices = std::set<std::size_t>;

template <class T>
void eraseThose(std::vector<T>& list, Indices const& indices, std::string_view what) {
    if (!indices.empty() && *indices.rbegin() >= list.size()) {
        throw std::invalid_argument(fmt::format("there is no {} {}; expected a number below {}", what,
                                                *indices.rbegin(), list.size()));
    }
    for (auto at = indices.rbegin(); at != indices.rend(); ++at) {
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(*at));
    }
}

/// Makes inputs and wires name the remaining placed objects as the reduced run does. A wire to an object that
/// is gone is removed with it, as in the game.
void renameIn(Solution& solution, PlacedNames const& names) {
    std::erase_if(solution.wires,
                  [&](LevelConnection const& wire) { return names.isGone(wire.a) || names.isGone(wire.b); });
    for (LevelConnection& wire : solution.wires) {
        wire.a = names.inReduced(wire.a);
        wire.b = names.inReduced(wire.b);
    }
    for (RecordedInput& input : solution.inputs) {
        input.object = names.inReduced(input.object);
        input.other = names.inReduced(input.other);
    }
}

/// The solution without entries of it.
Solution without(LevelFile const& level, Solution solution, std::map<LeftOut::Kind, Indices>& gone) {
    PlacedNames const names(level, solution.placements, gone[LeftOut::Kind::placement]);
    eraseThose(solution.wires, gone[LeftOut::Kind::wire], "wire");
    eraseThose(solution.inputs, gone[LeftOut::Kind::input], "input");
    eraseThose(solution.placements, gone[LeftOut::Kind::placement], "placement");
    if (!names.empty()) {
        renameIn(solution, names);
    }
    return solution;
}

} // namespace

Solution reducedSolution(LevelFile const& level, Solution const& solution,
                         std::vector<LeftOut> const& leftOut) {
    std::map<LeftOut::Kind, Indices> gone;
    for (LeftOut const& one : leftOut) {
        gone[one.kind].insert(one.index);
    }
    return without(level, solution, gone);
}

PlacedNames namesWithout(LevelFile const& level, Variation const& variation) {
    Indices gone;
    for (LeftOut const& one : variation.leftOut) {
        if (one.kind == LeftOut::Kind::placement && one.index < variation.solution.placements.size()) {
            gone.insert(one.index);
        }
    }
    return {level, variation.solution.placements, gone};
}

ReducedLevel reduced(LevelFile const& level, Variation const& variation) {
    std::map<LeftOut::Kind, Indices> indices;
    ReducedLevel left{level, variation.solution, {}, {}};
    for (LeftOut const& one : variation.leftOut) {
        switch (one.kind) {
        case LeftOut::Kind::effect:
            if (!dispensableGameEffects().contains(one.a)) {
                throw std::invalid_argument(fmt::format("there is no effect '{}' to be left out", one.a));
            }
            left.effects.insert(one.a);
            break;
        case LeftOut::Kind::contact:
        case LeftOut::Kind::dip:
        case LeftOut::Kind::device:
        case LeftOut::Kind::switching:
            left.later.push_back(one);
            break;
        default:
            indices[one.kind].insert(one.index);
        }
    }
    std::sort(left.later.begin(), left.later.end(),
              [](LeftOut const& x, LeftOut const& y) { return x.from < y.from; });
    PlacedNames const names = namesWithout(level, variation);
    for (LeftOut& one : left.later) {
        one.a = names.inReduced(one.a);
        one.b = names.inReduced(one.b);
    }
    left.solution = without(level, std::move(left.solution), indices);
    for (std::string const& effect : left.effects) {
        left.level.detail.erase(effect);
        std::erase_if(left.solution.changes, [&](RecordedChange const& change) {
            return change.kind == RecordedChange::Kind::detail && change.subject == effect;
        });
    }
    return left;
}

} // namespace trembler::insight
