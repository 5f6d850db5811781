#include "runtime/level/read/read_level.hpp"

#include "runtime/level/json/limits.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/level/property/property_reader.hpp"
#include "runtime/level/read/check_level.hpp"
#include "runtime/level/read/migrations.hpp"
#include "runtime/level/read/read_area.hpp"
#include "runtime/level/read/read_editor.hpp"
#include "runtime/level/read/read_extensions.hpp"
#include "runtime/level/read/read_solutions.hpp"
#include "runtime/level/read/read_world.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

namespace trembler {
namespace {

/// Reads the sections of one level file into the level.
class LevelReader {
public:
    LevelReader(Registry const& registry, LevelFile& level) : registry_(registry), level_(level) {}

    void read(JsonNode const& node) {
        MemberReader reader(node, "a level: an object with \"version\", \"title\", \"objects\" ...");
        if (!reader.valid()) {
            return;
        }
        reader.know("version"); // has been read before
        reader.know("$schema"); // for editors
        if (auto const title = reader.required("title", "the name of the level, for people")) {
            level_.title = title->name("a title").value_or("");
        }
        if (auto const text = reader.optional("text")) {
            level_.text = text->text().value_or("");
        }
        if (auto const demonstration = reader.optional("demonstration")) {
            level_.demonstration = demonstration->boolean().value_or(false);
        }
        if (auto const mods = reader.optional("mods")) {
            level_.mods = readExtensions(*mods, registry_);
        }
        if (auto const world = reader.optional("world")) {
            readWorld(registry_, *world, level_);
        }
        if (auto const objects = reader.optional("objects");
            objects && objects->isList("a list of objects", limits::objects)) {
            for (std::size_t i = 0; i < objects->size(); ++i) {
                readObject(objects->element(i));
            }
        }
        if (auto const joints = reader.optional("joints");
            joints && joints->isList("a list of joints", limits::joints)) {
            for (std::size_t i = 0; i < joints->size(); ++i) {
                readJoint(joints->element(i));
            }
        }
        if (auto const list = reader.optional("connections");
            list && list->isList("a list of connections", limits::connections)) {
            for (std::size_t i = 0; i < list->size(); ++i) {
                readConnection(list->element(i));
            }
        }
        if (auto const placing = reader.optional("placing");
            placing && placing->isList("a list of areas", limits::areas)) {
            level_.placing.emplace();
            for (std::size_t i = 0; i < placing->size(); ++i) {
                if (auto area = readArea(placing->element(i))) {
                    level_.placing->push_back(std::move(*area));
                }
            }
        }
        if (auto const toolbox = reader.optional("toolbox");
            toolbox && toolbox->isList("a list of parts", limits::toolboxEntries)) {
            for (std::size_t i = 0; i < toolbox->size(); ++i) {
                readToolboxEntry(toolbox->element(i));
            }
        }
        if (auto const goals = reader.optional("goals"); goals && goals->isObject("a condition")) {
            level_.goals = goals->value();
        }
        if (auto const hints = reader.optional("hints");
            hints && hints->isList("a list of texts", limits::hints)) {
            for (std::size_t i = 0; i < hints->size(); ++i) {
                level_.hints.push_back(hints->element(i).text().value_or(""));
            }
        }
        if (auto const solutions = reader.optional("solutions")) {
            level_.solutions = readSolutions(*solutions);
        }
        if (auto const editor = reader.optional("editor")) {
            level_.editor = readEditor(*editor);
        }
        reader.finish();
        checkLevel(registry_, level_, namePaths_, node.problems());
    }

private:
    /// Records a name; complains if it is taken.
    void takeName(JsonNode const& node, std::string const& name) {
        if (name == "world") {
            node.complain("the name 'world' is taken", "another name: 'world' is the object under \"world\"");
        } else if (auto const [at, isNew] = namePaths_.try_emplace(name, node.path()); !isNew) {
            node.complain(fmt::format("the name '{}' is taken by {}", name, at->second), "a unique name");
        }
    }

    void readObject(JsonNode const& node) {
        if (!node.isObject("an object {\"name\", \"part\" or \"properties\", \"at\", ...}")) {
            return;
        }
        LevelObject object;
        object.path = node.path();
        auto const placementKeys = keysOf(registry_, PropertyPlace::placement);
        std::vector<std::string> known{"name", "part", "properties"};
        for (std::string const& key : placementKeys) {
            if (key != "name") {
                known.push_back(key);
            }
        }
        if (!node.has("name")) {
            node.complain("'name' is missing", "a name that no other object has");
        }
        for (auto const& [key, value] : node.value().items()) {
            JsonNode const member = node.member(key);
            if (key == "name") {
                if (auto const name = member.name("a name")) {
                    takeName(member, *name);
                    object.name = *name;
                }
            } else if (key == "part") {
                object.part = member.name("the name of a part").value_or("");
            } else if (key == "properties") {
                readProperties(object.properties, registry_, PropertyPlace::properties, member,
                               &level_.names);
            } else if (std::find(placementKeys.begin(), placementKeys.end(), key) != placementKeys.end()) {
                readPropertyInto(object.properties, *registry_.objectProperty(key), member, &level_.names);
            } else {
                bool const isProperty = registry_.objectProperty(key) != nullptr;
                node.complainAboutKey(key, fmt::format("unknown key '{}'{}", key, didYouMean(key, known)),
                                      isProperty ? "properties under \"properties\"" : listed(known));
            }
        }
        if (!object.name.empty()) {
            level_.objects.push_back(std::move(object));
        }
    }

    void readJoint(JsonNode const& node) {
        PropertyInfo const* const info = registry_.objectProperty("joint");
        if (info == nullptr) {
            node.complain("no effect of this program has joints", "no joints");
            return;
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
        if (auto value = readPropertyBeside(*info, node, &level_.names, others)) {
            joint.properties.set(std::move(value));
            level_.joints.push_back(std::move(joint));
        }
    }

    void readConnection(JsonNode const& node) {
        if (!node.value().is_object()) {
            readPair(node, {"", "", node.path()},
                     "a pair [\"object\", \"object\"] of names, or {\"between\", \"kind\"}");
            return;
        }
        MemberReader reader(node, "a connection {\"between\", \"kind\"}");
        auto const between = reader.required("between", "the pair of objects that it connects");
        auto const kind = reader.required("kind", listed(registry_.connectionKinds()));
        reader.finish();
        auto const name = kind ? kind->text(listed(registry_.connectionKinds())) : std::nullopt;
        if (!between || !name) {
            return;
        }
        if (std::vector<std::string> const kinds = registry_.connectionKinds();
            std::find(kinds.begin(), kinds.end(), *name) == kinds.end()) {
            kind->complain(
                fmt::format("there is no kind of connection '{}'{}", *name, didYouMean(*name, kinds)),
                listed(kinds));
            return;
        }
        readPair(*between, {"", "", node.path(), *name}, "a pair [\"object\", \"object\"] of names");
    }

    void readPair(JsonNode const& node, LevelConnection connection, std::string const& expected) {
        if (!node.value().is_array() || node.size() != 2) {
            node.complainOfType(expected);
            return;
        }
        auto const a = node.element(0).name("the name of an object");
        auto const b = node.element(1).name("the name of an object");
        if (a && b) {
            connection.a = *a;
            connection.b = *b;
            level_.connections.push_back(std::move(connection));
        }
    }

    void readToolboxEntry(JsonNode const& node) {
        MemberReader reader(node, "an object {\"part\", \"count\"}");
        auto const part = reader.required("part", "the name of a part");
        auto const count = reader.optional("count");
        reader.finish();
        auto const name = part ? part->name("the name of a part") : std::nullopt;
        auto const number = count ? count->integer(1, limits::toolboxCount) : std::optional<std::int64_t>(1);
        if (!name || !number) {
            return;
        }
        if (auto const [first, isNew] = toolPaths_.try_emplace(*name, node.path()); !isNew) {
            node.complain(fmt::format("'{}' is already in {}", *name, first->second), "every part once");
        }
        level_.toolbox.push_back({*name, static_cast<int>(*number), node.path()});
    }

    Registry const& registry_;
    LevelFile& level_;
    std::map<std::string, std::string> namePaths_;
    std::map<std::string, std::string> toolPaths_; // by part
};

} // namespace

LevelFile readLevel(Registry const& registry, std::shared_ptr<JsonDocument const> const& document,
                    Problems& problems) {
    LevelFile level;
    level.document = document;
    JsonNode const root(*document, document->root(), "", problems);
    if (!root.isObject("a level: an object with \"version\", \"title\", \"objects\" ...")) {
        return level;
    }
    if (!root.has("version")) {
        root.complain("'version' is missing", fmt::format("\"version\": {}", levelVersion));
        return level;
    }
    JsonNode const versionNode = root.member("version");
    auto const version = versionNode.integer(0, std::numeric_limits<std::int32_t>::max());
    if (!version) {
        return level;
    }
    if (*version > levelVersion) {
        versionNode.complain(fmt::format("version {} was made by a newer program than this one", *version),
                             fmt::format("at most {}", levelVersion));
        return level;
    }
    nlohmann::json current;
    if (*version < levelVersion) {
        current = document->root();
        migrate(current, static_cast<int>(*version));
    }
    // After a migration some paths are not in the text; their problems are shown at the value around them.
    JsonNode const top(*document, *version < levelVersion ? current : document->root(), "", problems);
    LevelReader(registry, level).read(top);
    return level;
}

LevelFile readLevel(Registry const& registry, std::shared_ptr<JsonDocument const> const& document) {
    Problems problems;
    LevelFile level = readLevel(registry, document, problems);
    problems.throwIfAny();
    return level;
}

LevelFile loadLevel(Registry const& registry, std::filesystem::path const& path) {
    return readLevel(registry, JsonDocument::load(path));
}

} // namespace trembler
