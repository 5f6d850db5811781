#include "runtime/level/write/write_level.hpp"

#include "runtime/level/property/field_outline.hpp"
#include "runtime/level/property/property_writer.hpp"
#include "runtime/level/read/read_teaching.hpp"
#include "runtime/level/read/read_texts.hpp"

namespace trembler {
namespace {

using Json = nlohmann::ordered_json;

Json pointJson(Vec2 p) {
    return Json::array({p.x, p.y});
}

Json boxJson(Box const& box) {
    return Json::array({box.corner.x, box.corner.y, box.size.x, box.size.y});
}

Json areaJson(Area const& area) {
    if (area.box) {
        return boxJson(*area.box);
    }
    Json corners = Json::array();
    for (Vec2 const corner : area.corners) {
        corners.push_back(pointJson(corner));
    }
    return corners;
}

/// Adds the members of one object to another.
void addAll(Json& to, Json const& from) {
    for (auto const& [key, value] : from.items()) {
        to[key] = value;
    }
}

Json objectJson(LevelObject const& object, NameTable const& names) {
    Json entry{{"name", object.name}};
    if (!object.part.empty()) {
        entry["part"] = object.part;
    }
    addAll(entry, writeProperties(object.properties, PropertyPlace::placement, names));
    if (object.flipped) {
        entry["flipped"] = true;
    }
    Json properties = writeProperties(object.properties, PropertyPlace::properties, names);
    if (!properties.empty()) {
        entry["properties"] = std::move(properties);
    }
    for (auto const& [piece, stated] : object.pieces) {
        entry["pieces"][piece] = writeProperties(stated, PropertyPlace::properties, names);
    }
    return entry;
}

Json jointJson(LevelJoint const& joint, NameTable const& names) {
    Json entry = Json::object();
    if (!joint.name.empty()) {
        entry["name"] = joint.name;
    }
    for (PropertySet::Entry const& property : joint.properties.entries()) {
        addAll(entry, writeProperty(*property.value, names));
    }
    return entry;
}

Json inputJson(RecordedInput const& input) {
    Json entry{{"frame", input.frame}};
    std::string const key(playerInputNames[static_cast<std::size_t>(input.kind)]);
    switch (input.kind) {
    case PlayerInput::Kind::grab:
        entry[key] = input.object;
        entry["at"] = pointJson(input.at);
        break;
    case PlayerInput::Kind::move:
        entry[key] = pointJson(input.at);
        break;
    case PlayerInput::Kind::release:
        entry[key] = true;
        break;
    case PlayerInput::Kind::cut:
        entry[key] = Json::array({input.object, input.other});
        break;
    case PlayerInput::Kind::remove:
        entry[key] = input.object;
        break;
    }
    if (input.hand != 0) {
        entry["hand"] = input.hand;
    }
    return entry;
}

Json changeJson(RecordedChange const& change) {
    Json body;
    switch (change.kind) {
    case RecordedChange::Kind::detail:
        body[change.subject] = change.level;
        break;
    case RecordedChange::Kind::period:
        body[change.subject] = static_cast<std::int64_t>(change.value);
        break;
    case RecordedChange::Kind::setting:
        body[change.subject][change.field] = change.value;
        break;
    }
    std::string const key(recordedChangeNames[static_cast<std::size_t>(change.kind)]);
    return Json{{"frame", change.frame}, {key, std::move(body)}};
}

/// Adds a list under a key unless it is empty.
template <class List, class Write>
void addList(Json& to, char const* key, List const& list, Write const& write) {
    if (list.empty()) {
        return;
    }
    Json entries = Json::array();
    for (auto const& entry : list) {
        entries.push_back(write(entry));
    }
    to[key] = std::move(entries);
}

Json worldJson(LevelFile const& level, NameTable const& names) {
    Json world = writeProperties(level.world, PropertyPlace::world, names);
    if (level.bounds) {
        world["bounds"] = boxJson(*level.bounds);
    }
    if (!level.detail.empty()) {
        world["detail"] = level.detail;
    }
    return world;
}

} // namespace

Json countJson(int count) {
    return count == unlimitedCount ? Json(unlimitedWord) : Json(count);
}

Json writeSolution(Solution const& solution) {
    Json entry{{"name", solution.name}};
    addList(entry, "placements", solution.placements, [](Placement const& placement) {
        Json made{{"part", placement.part}, {"at", pointJson(placement.at)}};
        if (placement.angle != 0) {
            made["angle_deg"] = degrees(placement.angle);
        }
        if (placement.flipped) {
            made["flipped"] = true;
        }
        return made;
    });
    addList(entry, "wires", solution.wires, [](LevelConnection const& wire) {
        return Json::array({wire.a, wire.b});
    });
    addList(entry, "inputs", solution.inputs, inputJson);
    addList(entry, "changes", solution.changes, changeJson);
    if (!solution.solves) {
        entry["expect"] = "unsolved";
    }
    if (solution.frames) {
        entry["frames"] = *solution.frames;
    }
    return entry;
}

Json writeLevel(LevelFile const& level) {
    NameTable const& names = level.names;
    Json out{{"version", levelVersion}, {"title", level.title}};
    if (!level.text.empty()) {
        out["text"] = level.text;
    }
    if (level.demonstration) {
        out["demonstration"] = true;
    }
    if (!level.mods.empty()) {
        out["mods"] = level.mods;
    }
    Json world = worldJson(level, names);
    if (!world.empty()) {
        out["world"] = std::move(world);
    }
    addList(out, "objects", level.objects,
            [&](LevelObject const& object) { return objectJson(object, names); });
    addList(out, "joints", level.joints, [&](LevelJoint const& joint) { return jointJson(joint, names); });
    addList(out, "connections", level.connections, [](LevelConnection const& connection) {
        Json pair = Json::array({connection.a, connection.b});
        return connection.kind.empty() ? pair : Json{{"between", std::move(pair)}, {"kind", connection.kind}};
    });
    if (level.placing) {
        out["placing"] = Json::array();
        addList(out, "placing", *level.placing, areaJson);
    }
    addList(out, "toolbox", level.toolbox, [](ToolboxEntry const& entry) {
        return Json{{"part", entry.part}, {"count", countJson(entry.count)}};
    });
    if (level.wires > 0) {
        out["toolbox"].push_back(Json{{"wire", countJson(level.wires)}});
    }
    if (!level.goals.is_null()) {
        out["goals"] = level.goals;
    }
    if (!level.task.is_null()) {
        out["task"] = level.task;
    }
    addList(out, "hints", level.hints, [](std::string const& hint) { return Json(hint); });
    if (!level.teaching.empty()) {
        out["teaching"] = writeTeaching(level.teaching);
    }
    if (!level.texts.empty()) {
        out["texts"] = writeTexts(level.texts);
    }
    addList(out, "solutions", level.solutions, writeSolution);
    if (!level.editor.is_null()) {
        out["editor"] = level.editor;
    }
    return out;
}

std::string levelText(LevelFile const& level) {
    return writeLevel(level).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace trembler
