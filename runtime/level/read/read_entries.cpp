#include "runtime/level/read/read_entries.hpp"

#include "runtime/level/json/limits.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/level/property/property_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace trembler {
namespace {

std::optional<LevelConnection> readPairOfNames(JsonNode const& node, LevelConnection connection,
                                               std::string const& expected) {
    if (!node.value().is_array() || node.size() != 2) {
        node.complainOfType(expected);
        return std::nullopt;
    }
    auto const a = node.element(0).name("the name of an object");
    auto const b = node.element(1).name("the name of an object");
    if (!a || !b) {
        return std::nullopt;
    }
    connection.a = *a;
    connection.b = *b;
    return connection;
}

template <class Entry, class Read>
std::vector<Entry> readEntries(JsonNode const& node, std::string_view expected, std::size_t most,
                               Read const& read) {
    std::vector<Entry> all;
    if (node.isList(expected, most)) {
        for (std::size_t i = 0; i < node.size(); ++i) {
            if (auto entry = read(node.element(i))) {
                all.push_back(std::move(*entry));
            }
        }
    }
    return all;
}

} // namespace

std::vector<LevelObject> EntryReader::objects(JsonNode const& node) {
    return readEntries<LevelObject>(node, "a list of objects", limits::objects,
                                    [&](JsonNode const& entry) { return object(entry); });
}

std::vector<LevelJoint> EntryReader::joints(JsonNode const& node) {
    return readEntries<LevelJoint>(node, "a list of joints", limits::joints,
                                   [&](JsonNode const& entry) { return joint(entry); });
}

std::vector<LevelConnection> EntryReader::connections(JsonNode const& node) {
    return readEntries<LevelConnection>(node, "a list of connections", limits::connections,
                                        [&](JsonNode const& entry) { return connection(entry); });
}

void EntryReader::takeName(JsonNode const& node, std::string const& name) {
    if (name == "world") {
        node.complain("the name 'world' is taken", "another name: 'world' is the object under \"world\"");
    } else if (auto const [at, isNew] = paths_.try_emplace(name, node.path()); !isNew) {
        node.complain(fmt::format("the name '{}' is taken by {}", name, at->second), "a unique name");
    }
}

bool EntryReader::member(LevelObject& object, std::string const& key, JsonNode const& node) {
    if (key == "part") {
        object.part = node.name("the name of a part").value_or("");
    } else if (key == "flipped") {
        object.flipped = node.boolean().value_or(false);
    } else if (key == "properties") {
        readProperties(object.properties, registry_, PropertyPlace::properties, node, &names_);
    } else if (key == "pieces") {
        if (node.isObject("an object with one member per piece: {\"coil\": {...properties...}}")) {
            for (auto const& [piece, value] : node.value().items()) {
                readProperties(object.pieces[piece], registry_, PropertyPlace::properties, node.member(piece),
                               &names_);
            }
        }
    } else {
        PropertyInfo const* const info = registry_.objectProperty(key);
        if (info == nullptr || info->text.place != PropertyPlace::placement) {
            return false;
        }
        readPropertyInto(object.properties, *info, node, &names_);
    }
    return true;
}

std::optional<LevelObject> EntryReader::object(JsonNode const& node) {
    if (!node.isObject("an object {\"name\", \"part\" or \"properties\", \"at\", ...}")) {
        return std::nullopt;
    }
    LevelObject object;
    object.path = node.path();
    if (!node.has("name")) {
        node.complain("'name' is missing", "a name that no other object has");
    }
    for (auto const& [key, value] : node.value().items()) {
        JsonNode const found = node.member(key);
        if (key == "name") {
            if (auto const name = found.name("a name")) {
                takeName(found, *name);
                object.name = *name;
            }
        } else if (!member(object, key, found)) {
            std::vector<std::string> known{"name", "part", "properties", "flipped", "pieces"};
            for (std::string const& placement : keysOf(registry_, PropertyPlace::placement)) {
                if (placement != "name") {
                    known.push_back(placement);
                }
            }
            bool const isProperty = registry_.objectProperty(key) != nullptr;
            node.complainAboutKey(key, fmt::format("unknown key '{}'{}", key, didYouMean(key, known)),
                                  isProperty ? "properties under \"properties\"" : listed(known));
        }
    }
    return object.name.empty() ? std::nullopt : std::optional(std::move(object));
}

std::optional<LevelJoint> EntryReader::joint(JsonNode const& node) {
    PropertyInfo const* const info = registry_.objectProperty("joint");
    if (info == nullptr) {
        node.complain("no effect of this program has joints", "no joints");
        return std::nullopt;
    }
    LevelJoint joint;
    joint.path = node.path();
    if (node.has("name")) {
        JsonNode const member = node.member("name");
        if (auto const name = member.name("a name")) {
            takeName(member, *name);
            joint.name = *name;
        }
    }
    std::array<std::string, 1> const others{"name"};
    auto value = readPropertyBeside(*info, node, &names_, others);
    if (!value) {
        return std::nullopt;
    }
    joint.properties.set(std::move(value));
    return joint;
}

std::optional<LevelConnection> EntryReader::connection(JsonNode const& node) {
    if (!node.value().is_object()) {
        return readPairOfNames(node, {"", "", node.path()},
                               "a pair [\"object\", \"object\"] of names, or {\"between\", \"kind\"}");
    }
    std::vector<std::string> const kinds = registry_.connectionKinds();
    MemberReader reader(node, "a connection {\"between\", \"kind\"}");
    auto const between = reader.required("between", "the pair of objects that it connects");
    auto const kind = reader.required("kind", listed(kinds));
    reader.finish();
    auto const name = kind ? kind->text(listed(kinds)) : std::nullopt;
    if (!between || !name) {
        return std::nullopt;
    }
    if (std::find(kinds.begin(), kinds.end(), *name) == kinds.end()) {
        kind->complain(fmt::format("there is no kind of connection '{}'{}", *name, didYouMean(*name, kinds)),
                       listed(kinds));
        return std::nullopt;
    }
    return readPairOfNames(*between, {"", "", node.path(), *name},
                           "a pair [\"object\", \"object\"] of names");
}

} // namespace trembler
