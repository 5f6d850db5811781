#include "puzzle/edit/commands/arrange.hpp"

#include "puzzle/edit/commands/editor_state.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/tree/extent.hpp"
#include "puzzle/edit/tree/motion.hpp"
#include "puzzle/edit/tree/object_values.hpp"
#include "puzzle/edit/tree/shape_change.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/property/field_outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace trembler::edit {
namespace {

using Names = std::vector<std::string>;

/// The objects without the locked ones, each once.
Names movable(Json const& level, Names const& names) {
    mustHaveObjects(level, names);
    Names free;
    std::set<std::string> known;
    for (std::string const& name : unlocked(level, names)) {
        if (known.insert(name).second) {
            free.push_back(name);
        }
    }
    if (free.empty()) {
        throw CommandError(names.size() == 1 ? "the object is locked" : "the objects are locked");
    }
    return free;
}

void mustBeFinite(Vec2 value) {
    if (!isFinite(value)) {
        throw CommandError("a number is too large");
    }
}

/// Objects that are aligned as one: the members of a group among those selected, or a single one.
struct Unit {
    Names names;
    Box extent;

    [[nodiscard]] double low(Axis axis) const { return axis == Axis::x ? extent.corner.x : extent.corner.y; }
    [[nodiscard]] double size(Axis axis) const { return axis == Axis::x ? extent.size.x : extent.size.y; }
    [[nodiscard]] double middle(Axis axis) const { return low(axis) + size(axis) / 2; }
};

std::vector<Unit> unitsOf(GameData const& data, Json const& level, Names const& names) {
    std::vector<Unit> units;
    std::set<std::string> done;
    std::set<std::string> const wanted(names.begin(), names.end());
    for (std::string const& name : names) {
        if (done.contains(name)) {
            continue;
        }
        Unit unit;
        for (std::string const& member : groupOf(level, name)) {
            if (wanted.contains(member) && done.insert(member).second) {
                unit.names.push_back(member);
            }
        }
        unit.extent = extentOfObjects(data, level, unit.names).value_or(Box{});
        units.push_back(std::move(unit));
    }
    return units;
}

Vec2 along(Axis axis, double way) {
    return axis == Axis::x ? Vec2{way, 0} : Vec2{0, way};
}

Command shifted(GameData const& data, std::string name, Shifts shifts, Names names) {
    return {std::move(name),
            [&data, shifts = std::move(shifts)](Json& tree) { shiftObjects(data, tree, shifts); },
            std::move(names)};
}

std::string_view wordsOf(Alignment alignment) {
    switch (alignment) {
    case Alignment::left:
        return "left edges";
    case Alignment::right:
        return "right edges";
    case Alignment::top:
        return "top edges";
    case Alignment::bottom:
        return "bottom edges";
    case Alignment::centresX:
    case Alignment::centresY:
        break;
    }
    return "centres";
}

} // namespace

Command moveObjects(GameData const& data, Json const& level, Names const& names, Vec2 by) {
    mustBeFinite(by);
    Names const free = movable(level, names);
    Shifts shifts;
    for (std::string const& name : free) {
        shifts[name] = by;
    }
    return shifted(data, fmt::format("Move {}", objectsInWords(free)), std::move(shifts), free);
}

Command rotateObjects(GameData const& data, Json const& level, Names const& names, double degreesToTurn,
                      Vec2 centre) {
    mustBeFinite(centre);
    mustBeFinite({degreesToTurn, 0});
    Names const free = movable(level, names);
    return {fmt::format("Rotate {}", objectsInWords(free)),
            [&data, free, degreesToTurn, centre](Json& tree) {
                double const turn = radians(degreesToTurn);
                Motion const motion{[=](Vec2 point) { return centre + rotated(point - centre, turn); },
                                    [=](Vec2 way) { return rotated(way, turn); }};
                ObjectEntries const entries(tree);
                for (std::string const& name : free) {
                    Json& entry = entries.of(name);
                    setPlace(entry, motion.point(placeOf(entry)));
                    setAngle(entry, angleOf(entry) + degreesToTurn);
                }
                moveJoints(data, tree, {free.begin(), free.end()}, motion);
            },
            free};
}

Command scaleObjects(GameData const& data, Json const& level, Names const& names, Vec2 factors, Vec2 centre) {
    mustBeFinite(factors);
    mustBeFinite(centre);
    if (factors.x <= 0 || factors.y <= 0) {
        throw CommandError("a factor must be above zero");
    }
    Names const free = movable(level, names);
    return {fmt::format("Scale {}", objectsInWords(free)),
            [&data, free, factors, centre](Json& tree) {
                Motion const motion{[=](Vec2 point) {
                                        Vec2 const way = point - centre;
                                        return centre + Vec2{way.x * factors.x, way.y * factors.y};
                                    },
                                    [](Vec2 way) { return way; }};
                ObjectEntries const entries(tree);
                for (std::string const& name : free) {
                    Json& entry = entries.of(name);
                    scaleEntry(data, entry, factors);
                    setPlace(entry, motion.point(placeOf(entry)));
                }
                moveJoints(data, tree, {free.begin(), free.end()}, motion);
            },
            free};
}

bool mayScale(GameData const& data, Json const& level, Names const& names, Vec2 factors) {
    try {
        // Only of these objects: a copy of a large level takes longer than scaling one of them.
        std::set<std::string> const wanted(names.begin(), names.end());
        Json copy{{"objects", Json::array()}};
        if (Json const* const list = findList(level, "objects")) {
            std::copy_if(list->begin(), list->end(),
                         std::back_inserter(copy["objects"].get_ref<Json::array_t&>()),
                         [&](Json const& entry) { return wanted.contains(textOf(entry, "name")); });
        }
        if (auto const editor = level.find("editor"); editor != level.end()) {
            copy["editor"] = *editor;
        }
        scaleObjects(data, copy, names, factors, {}).change(copy);
        return true;
    } catch (CommandError const&) {
        return false;
    }
}

Command mirrorObjects(GameData const& data, Json const& level, Names const& names, Mirror mirror,
                      Vec2 centre) {
    mustBeFinite(centre);
    Names const free = movable(level, names);
    bool const atVertical = mirror == Mirror::leftRight;
    return {fmt::format("Mirror {}", objectsInWords(free)),
            [&data, free, atVertical, centre](Json& tree) {
                auto const flip = [=](Vec2 way) {
                    return atVertical ? Vec2{-way.x, way.y} : Vec2{way.x, -way.y};
                };
                Motion const motion{[=](Vec2 point) { return centre + flip(point - centre); }, flip, true};
                ObjectEntries const entries(tree);
                for (std::string const& name : free) {
                    Json& entry = entries.of(name);
                    setPlace(entry, motion.point(placeOf(entry)));
                    mirrorEntry(data, entry, atVertical);
                }
                moveJoints(data, tree, {free.begin(), free.end()}, motion);
            },
            free};
}

Command alignObjects(GameData const& data, Json const& level, Names const& names, Alignment alignment) {
    Names const free = movable(level, names);
    std::vector<Unit> const units = unitsOf(data, level, free);
    if (units.size() < 2) {
        throw CommandError("aligning needs at least two objects that are not in one group");
    }
    Box const all = extentOfObjects(data, level, free).value_or(Box{});
    bool const horizontal =
        alignment == Alignment::left || alignment == Alignment::right || alignment == Alignment::centresX;
    Axis const axis = horizontal ? Axis::x : Axis::y;
    Unit const whole{free, all};
    Shifts shifts;
    for (Unit const& unit : units) {
        double way = whole.middle(axis) - unit.middle(axis);
        if (alignment == Alignment::left || alignment == Alignment::bottom) {
            way = whole.low(axis) - unit.low(axis);
        } else if (alignment == Alignment::right || alignment == Alignment::top) {
            way = whole.low(axis) + whole.size(axis) - unit.low(axis) - unit.size(axis);
        }
        for (std::string const& name : unit.names) {
            shifts[name] = along(axis, way);
        }
    }
    return shifted(data, fmt::format("Align {} of {}", wordsOf(alignment), objectsInWords(free)),
                   std::move(shifts), free);
}

Command distributeObjects(GameData const& data, Json const& level, Names const& names, Axis axis) {
    Names const free = movable(level, names);
    std::vector<Unit> units = unitsOf(data, level, free);
    if (units.size() < 3) {
        throw CommandError("distributing needs at least three objects that are not in one group");
    }
    std::stable_sort(units.begin(), units.end(),
                     [&](Unit const& a, Unit const& b) { return a.middle(axis) < b.middle(axis); });
    double gaps = units.back().low(axis) - units.front().low(axis) - units.front().size(axis);
    for (std::size_t i = 1; i + 1 < units.size(); ++i) {
        gaps -= units[i].size(axis);
    }
    double const gap = gaps / static_cast<double>(units.size() - 1);
    double next = units.front().low(axis) + units.front().size(axis) + gap;
    Shifts shifts;
    for (std::size_t i = 1; i + 1 < units.size(); ++i) {
        for (std::string const& name : units[i].names) {
            shifts[name] = along(axis, next - units[i].low(axis));
        }
        next += units[i].size(axis) + gap;
    }
    return shifted(data, fmt::format("Distribute {}", objectsInWords(free)), std::move(shifts), free);
}

} // namespace trembler::edit
