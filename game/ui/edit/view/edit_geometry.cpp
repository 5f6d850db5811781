#include "game/ui/edit/view/edit_geometry.hpp"

#include "puzzle/edit/commands/arrange.hpp"
#include "puzzle/edit/commands/connect.hpp"
#include "puzzle/edit/commands/editor_state.hpp"
#include "puzzle/edit/commands/goals.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/commands/shapes.hpp"
#include "puzzle/edit/tree/extent.hpp"
#include "puzzle/edit/tree/part_statements.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "render/scene/objects/wires.hpp"

#include <algorithm>
#include <cstdlib>

namespace trembler::ui {
namespace {

using namespace render;

constexpr double sceneReach = 6; // pixels at UI scale 1
constexpr double knobGap = 10;   // pixels at UI scale 1, between the selection and the others
constexpr double turnGap = 34;   // pixels at UI scale 1, between the selection and its knob

double distanceToSegment(Vec2 p, Vec2 a, Vec2 b) {
    Vec2 const along = b - a;
    double const square = along.x * along.x + along.y * along.y;
    double const share =
        square > 0 ? std::clamp(((p.x - a.x) * along.x + (p.y - a.y) * along.y) / square, 0.0, 1.0) : 0.0;
    return trembler::length(p - (a + share * along));
}

std::optional<Area> areaFrom(edit::Json const& value) {
    if (!value.is_array() || value.empty()) {
        return {};
    }
    auto const number = [](edit::Json const& one) { return one.is_number() ? one.get<double>() : 0.0; };
    if (value.size() == 4 && value[0].is_number()) {
        return Area{Box{{number(value[0]), number(value[1])}, {number(value[2]), number(value[3])}}, {}};
    }
    Area area;
    for (edit::Json const& corner : value) {
        if (!corner.is_array() || corner.size() != 2) {
            return {};
        }
        area.corners.push_back({number(corner[0]), number(corner[1])});
    }
    return area;
}

/// The topmost object under a point, with or without locked ones; invalid if there is none.
ObjectId topmost(EditParts const& parts, Vec2 at, bool locked) {
    World const* const world = parts.world.world();
    if (world == nullptr) {
        return {};
    }
    double const reach = sceneReach * parts.pointer.pixel;
    ObjectId nearest;
    double best = reach;
    auto const order = FactsReader(*world).drawOrder();
    for (auto facts = order.rbegin(); facts != order.rend(); ++facts) {
        double const distance = distanceTo(*facts, parts.scene.poseOf(*world, facts->id), toPoint(at));
        if (distance > reach) {
            continue;
        }
        std::string const& entry = parts.world.entryOf(facts->id);
        if (entry.empty() || (!locked && edit::isLocked(parts.tree(), entry))) {
            continue;
        }
        if (distance <= 0) {
            return facts->id;
        }
        if (distance < best) {
            best = distance;
            nearest = facts->id;
        }
    }
    return nearest;
}

/// The name of its entry; "" for none.
std::string entryAt(EditParts const& parts, ObjectId object) {
    return object.valid() ? parts.world.entryOf(object) : std::string();
}

AboutSelection const& aboutSelection(EditParts const& parts) {
    AboutSelection& about = parts.about;
    if (about.known && about.revision == parts.document.revision() && about.names == parts.selected()) {
        return about;
    }
    about = {parts.document.revision(), parts.selected(), {}, {}, false, false, true};
    auto const names = edit::unlocked(parts.tree(), parts.selected());
    if (!names.empty()) {
        about.box = edit::extentOfObjects(*parts.data, parts.tree(), names);
        about.scales = edit::mayScale(*parts.data, parts.tree(), names, {1.1, 1.1});
        if (names.size() == 1) {
            about.corners = edit::outlineCorners(*parts.data, parts.tree(), names.front());
        }
        about.stretches = about.scales && edit::mayScale(*parts.data, parts.tree(), names, {1.1, 1});
    }
    return about;
}

} // namespace

std::string pickObject(EditParts const& parts, Vec2 at) {
    return entryAt(parts, topmost(parts, at, false));
}

ObjectId pickTopmost(EditParts const& parts, Vec2 at) {
    return topmost(parts, at, true);
}

std::string pickPiece(EditParts const& parts, std::string const& entry, Vec2 at) {
    ObjectId const picked = topmost(parts, at, false);
    if (entry.empty() || entryAt(parts, picked) != entry) {
        return {};
    }
    edit::PartStatements ofParts(*parts.data);
    edit::Json const* const stated = edit::findObject(parts.tree(), entry);
    std::string const part = stated == nullptr ? std::string() : edit::textOf(*stated, "part");
    std::vector<edit::PartPiece> const& pieces = ofParts.pieces(part);
    std::size_t const index = parts.world.pieceOf(picked);
    if (index >= pieces.size()) { // a part of one object
        return {};
    }
    for (edit::InspectedPiece const& piece : edit::inspectPieces(*parts.data, parts.tree(), {entry})) {
        if (ofParts.pieceNamed(part, piece.name) == pieces[index].name) {
            return piece.main && !piece.stated ? std::string() : piece.name;
        }
    }
    return {};
}

std::vector<std::string> objectsWithin(EditParts const& parts, Vec2 a, Vec2 b) {
    std::vector<std::string> names;
    World const* const world = parts.world.world();
    if (world == nullptr) {
        return names;
    }
    Extent box;
    box.add(toPoint(a));
    box.add(toPoint(b));
    // An entry of several pieces is within it if all of them are.
    std::vector<std::string> outside;
    for (Facts const& facts : FactsReader(*world).drawOrder()) {
        std::string const& name = parts.world.entryOf(facts.id);
        Extent const own = extentOf(facts, parts.scene.poseOf(*world, facts.id));
        if (own.empty() || name.empty() || edit::isLocked(parts.tree(), name)) {
            continue;
        }
        auto& list = box.contains(own.lower) && box.contains(own.upper) ? names : outside;
        if (std::find(list.begin(), list.end(), name) == list.end()) {
            list.push_back(name);
        }
    }
    std::erase_if(names, [&](std::string const& name) {
        return std::find(outside.begin(), outside.end(), name) != outside.end();
    });
    return names;
}

std::optional<SelectionHandles> handlesOf(EditParts const& parts) {
    AboutSelection const& about = aboutSelection(parts);
    if (!about.box || parts.document.readOnly()) {
        return {};
    }
    SelectionHandles handles{*about.box, {}, {}, {}};
    Vec2 const low = about.box->corner;
    Vec2 const high = about.box->corner + about.box->size;
    Vec2 const middle = handles.middle();
    handles.turn = {middle.x, high.y + turnGap * parts.pointer.pixel};
    if (about.scales) {
        handles.edges = {low, {high.x, low.y}, high, {low.x, high.y}};
        if (about.stretches) {
            handles.edges.insert(
                handles.edges.end(),
                {{low.x, middle.y}, {high.x, middle.y}, {middle.x, low.y}, {middle.x, high.y}});
        }
    }
    // Outside of the box, so that a small object can still be dragged by its middle.
    auto const sign = [](double x) { return x > 1e-12 ? 1.0 : x < -1e-12 ? -1.0 : 0.0; };
    for (Vec2 const edge : handles.edges) {
        Vec2 const outwards{sign(edge.x - middle.x), sign(edge.y - middle.y)};
        handles.scaling.push_back(edge + knobGap * parts.pointer.pixel * outwards);
    }
    return handles;
}

std::vector<Vec2> shapeCorners(EditParts const& parts) {
    AboutSelection const& about = aboutSelection(parts);
    bool const one = parts.selected().size() == 1 && parts.selection.piece().empty();
    return one && about.box && !parts.document.readOnly() ? about.corners : std::vector<Vec2>();
}

std::vector<SceneArea> sceneAreas(EditParts const& parts) {
    std::vector<SceneArea> all;
    auto const add = [&](EntryKind kind, std::string path, Area area) {
        bool const selected = parts.selection.kind() == kind && parts.selection.path() == path;
        all.push_back({kind, std::move(path), std::move(area), selected});
    };
    if (parts.tree().is_object() && parts.tree().contains("placing") && parts.tree()["placing"].is_array()) {
        edit::Json const& placing = parts.tree()["placing"];
        for (std::size_t i = 0; i < placing.size(); ++i) {
            if (auto area = areaFrom(placing[i])) {
                add(EntryKind::placing, "/placing/" + std::to_string(i), std::move(*area));
            }
        }
    }
    for (edit::GoalLine const& line : edit::goalLines(parts.tree(), parts.goalTree)) {
        if (!line.condition.is_object() || !line.condition.contains(line.kind)) {
            continue;
        }
        edit::Json const& body = line.condition[line.kind];
        if (body.is_object() && body.contains("area")) {
            if (auto area = areaFrom(body["area"])) {
                add(EntryKind::goalArea, line.place, std::move(*area));
            }
        }
    }
    return all;
}

std::vector<Vec2> areaCorners(Area const& area) {
    if (!area.box) {
        return area.corners;
    }
    Vec2 const low = area.box->corner;
    Vec2 const high = low + area.box->size;
    return {low, {high.x, low.y}, high, {low.x, high.y}};
}

Area withCorner(Area const& area, std::size_t corner, Vec2 to) {
    if (!area.box) {
        Area changed = area;
        changed.corners.at(corner) = to;
        return changed;
    }
    Vec2 const opposite = areaCorners(area).at((corner + 2) % 4);
    Vec2 const low{std::min(opposite.x, to.x), std::min(opposite.y, to.y)};
    Vec2 const high{std::max(opposite.x, to.x), std::max(opposite.y, to.y)};
    return {Box{low, {std::max(high.x - low.x, 0.01), std::max(high.y - low.y, 0.01)}}, {}};
}

Area movedArea(Area const& area, Vec2 by) {
    Area moved = area;
    if (moved.box) {
        moved.box->corner += by;
    }
    for (Vec2& corner : moved.corners) {
        corner += by;
    }
    return moved;
}

SceneArea pickArea(EditParts const& parts, Vec2 at) {
    double const reach = sceneReach * parts.pointer.pixel;
    for (SceneArea const& area : sceneAreas(parts)) {
        std::vector<Vec2> const corners = areaCorners(area.area);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if (distanceToSegment(at, corners[i], corners[(i + 1) % corners.size()]) < reach) {
                return area;
            }
        }
    }
    return {};
}

std::vector<JointPoint> jointPoints(EditParts const& parts) {
    std::vector<JointPoint> points;
    for (edit::JointEntry const& joint : edit::jointsOf(parts.tree())) {
        points.push_back({joint.index, "at", joint.at});
        if (joint.atB != joint.at) {
            points.push_back({joint.index, "at_b", joint.atB});
        }
        edit::Json const& entry = parts.tree()["joints"][joint.index];
        for (char const* const field : {"ground_a", "ground_b"}) { // of pulleys
            if (auto const at = entry.contains(field) ? edit::pointOf(entry[field]) : std::nullopt) {
                points.push_back({joint.index, field, *at});
            }
        }
    }
    return points;
}

std::optional<std::size_t> pickJoint(EditParts const& parts, Vec2 at) {
    for (JointPoint const& point : jointPoints(parts)) {
        if (trembler::length(point.at - at) < 1.6 * sceneReach * parts.pointer.pixel) {
            return point.joint;
        }
    }
    return {};
}

std::vector<Point> pathOf(EditParts const& parts, std::string const& a, std::string const& b) {
    World const* const world = parts.world.world();
    if (world == nullptr) {
        return {};
    }
    ObjectId const first = world->store().find(a);
    ObjectId const second = world->store().find(b);
    if (!first.valid() || !second.valid()) {
        return {};
    }
    FactsReader const reader(*world);
    return cablePath(reader.of(first), parts.scene.poseOf(*world, first), reader.of(second),
                     parts.scene.poseOf(*world, second));
}

std::optional<std::size_t> pickConnection(EditParts const& parts, Vec2 at) {
    for (edit::ConnectionEntry const& connection : edit::connectionsOf(parts.tree())) {
        std::vector<Point> const path = pathOf(parts, connection.a, connection.b);
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            if (distanceToSegment(at, {path[i].x, path[i].y}, {path[i + 1].x, path[i + 1].y}) <
                sceneReach * parts.pointer.pixel) {
                return connection.index;
            }
        }
    }
    return {};
}

std::size_t indexOfPath(std::string const& path) {
    return static_cast<std::size_t>(std::strtoul(path.c_str() + path.rfind('/') + 1, nullptr, 10));
}

} // namespace trembler::ui
