#include "game/ui/edit/commands/edit_actions.hpp"
#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/tools/join_ends.hpp"
#include "puzzle/edit/commands/connect.hpp"
#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/commands/goals.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/commands/shapes.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/placement.hpp"

#include <array>

namespace trembler::ui::actions {
namespace {

using edit::Json;

/// Where an object, or a piece of one, is at the start; the middle of the view for one without a place.
Vec2 placeOf(EditParts const& parts, JoinEnd const& end) {
    auto const* const places = parts.world.world()->store().findColumn<Position>();
    Position const* const place = places == nullptr ? nullptr : places->find(end.object);
    return place == nullptr ? parts.middleOfView() : place->value;
}

/// A joint or a wire between the two selected objects; a joint of a single one holds it to the world.
void joinSelected(EditParts& parts, Tool tool) {
    std::vector<JoinEnd> const ends = selectedEnds(parts, tool);
    bool const enough = ends.size() == 2 || (ends.size() == 1 && tool == Tool::joint);
    if (!enough || !ends.front().valid() || !ends.back().valid()) {
        return parts.tell(words::selectTwo);
    }
    JoinEnd const to = ends.size() == 2 ? ends[1] : JoinEnd{};
    Join const join{tool, ends.front(), to, placeOf(parts, ends.front()), placeOf(parts, ends.back())};
    if (std::string const why = whyNoJoin(parts, join); !why.empty()) {
        return parts.tell(why, render::ToastKind::Trouble);
    }
    if (tool == Tool::wire) {
        return connectObjects(parts, join.from.name, join.to.name);
    }
    joinObjects(parts, join.from.name, join.to.name, join.at, join.atB);
}

/// The result of the tool without the mouse: an object in the middle of the view, or a joint or wire between
/// two selected objects.
void makeInTheMiddle(EditParts& parts, Tool tool) {
    Vec2 const middle = parts.middleOfView();
    switch (tool) {
    case Tool::box:
        return addDrawn(parts, [&](Json const& level) {
            return shapeCommand(level, edit::drawnBox(middle - Vec2{0.2, 0.1}, middle + Vec2{0.2, 0.1}),
                                "box");
        });
    case Tool::disc:
        return addDrawn(parts, [&](Json const& level) {
            return shapeCommand(level, edit::drawnDisc(middle, middle + Vec2{0.15, 0}), "disc");
        });
    case Tool::capsule:
        return addDrawn(parts, [&](Json const& level) {
            return shapeCommand(
                level, edit::drawnCapsule(middle - Vec2{0.2, 0}, middle + Vec2{0.2, 0}, parts.capsuleRadius),
                "capsule");
        });
    case Tool::polygon:
        return addDrawn(parts, [&](Json const& level) {
            std::array const corners{middle - Vec2{0.2, 0.1}, middle + Vec2{0.2, -0.1},
                                     middle + Vec2{0, 0.2}};
            return shapeCommand(level, edit::drawnPolygon(corners), "polygon");
        });
    case Tool::joint:
    case Tool::wire:
        return joinSelected(parts, tool);
    case Tool::placing:
    case Tool::goalArea:
        return addArea(parts, tool, Area{Box{middle - Vec2{0.5, 0.5}, {1, 1}}, {}});
    case Tool::select:
        break;
    }
}

} // namespace

edit::Command shapeCommand(Json const& level, edit::DrawnShape const& drawn, std::string const& name) {
    Json properties = Json::object();
    properties["material"] = "wood";
    properties["shape"] = drawn.shape;
    return edit::addObject(level, {.part = {},
                                   .at = drawn.at,
                                   .angleDegrees = drawn.angleDegrees,
                                   .properties = std::move(properties),
                                   .name = name});
}

void take(EditParts& parts, Tool tool) {
    parts.partInHand.clear();
    if (parts.tool == tool && tool != Tool::select) {
        return makeInTheMiddle(parts, tool);
    }
    parts.tool = tool;
}

void addDrawn(EditParts& parts, std::function<edit::Command(Json const&)> const& make) {
    parts.run(make); // the tool stays
}

void addPart(EditParts& parts, std::string const& part, Vec2 at) {
    parts.run([&](Json const& level) { return edit::addObject(level, {.part = part, .at = at}); });
}

void joinObjects(EditParts& parts, std::string const& a, std::string const& b, Vec2 at, Vec2 atB) {
    bool const done = parts.run([&](Json const& level) {
        return edit::addJoint(*parts.data, level, parts.jointForm, a, b, at, atB);
    });
    if (done) {
        std::size_t const count = edit::jointsOf(parts.tree()).size();
        parts.selection.choose(EntryKind::joint, "/joints/" + std::to_string(count == 0 ? 0 : count - 1));
        parts.tab = Tab::properties;
    }
}

void connectObjects(EditParts& parts, std::string const& a, std::string const& b) {
    parts.run([&](Json const& level) { return edit::addConnection(level, a, b); });
}

void addArea(EditParts& parts, Tool tool, Area const& area) {
    if (tool == Tool::placing) {
        if (parts.run([&](Json const& level) { return edit::addPlacingArea(level, area); })) {
            auto const& placing = parts.tree().at("placing");
            parts.selection.choose(EntryKind::placing, "/placing/" + std::to_string(placing.size() - 1));
        }
        return;
    }
    std::vector<std::string> objects = parts.selected();
    if (objects.empty()) {
        return parts.tell(words::selectForGoal);
    }
    objects.resize(1);
    bool const done = parts.run([&](Json const& level) {
        return edit::addGoal(level, "", edit::newCondition("inside", objects, area), parts.goalTree);
    });
    if (done) {
        parts.tab = Tab::goals;
    }
}

} // namespace trembler::ui::actions
