#include "runtime/level/read/read_level.hpp"

#include "runtime/level/json/limits.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/level/read/check_level.hpp"
#include "runtime/level/read/migrations.hpp"
#include "runtime/level/read/read_area.hpp"
#include "runtime/level/read/read_editor.hpp"
#include "runtime/level/read/read_entries.hpp"
#include "runtime/level/read/read_extensions.hpp"
#include "runtime/level/read/read_teaching.hpp"
#include "runtime/level/read/read_texts.hpp"
#include "runtime/level/read/read_world.hpp"
#include "runtime/level/read/solutions/read_solutions.hpp"

#include <fmt/format.h>

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
        EntryReader entries(registry_, level_.names);
        if (auto const objects = reader.optional("objects")) {
            level_.objects = entries.objects(*objects);
        }
        if (auto const joints = reader.optional("joints")) {
            level_.joints = entries.joints(*joints);
        }
        if (auto const connections = reader.optional("connections")) {
            level_.connections = entries.connections(*connections);
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
        if (auto const task = reader.optional("task"); task && task->isObject("a condition")) {
            level_.task = task->value();
            if (!level_.demonstration) {
                task->complain("only a demonstration has a task",
                               "\"demonstration\": true, or the condition under \"goals\"");
            }
        }
        if (auto const texts = reader.optional("texts")) {
            level_.texts = readTexts(*texts, TextsOf::level);
        }
        if (auto const hints = reader.optional("hints");
            hints && hints->isList("a list of texts", limits::hints)) {
            for (std::size_t i = 0; i < hints->size(); ++i) {
                level_.hints.push_back(hints->element(i).text().value_or(""));
            }
        }
        if (auto const teaching = reader.optional("teaching")) {
            level_.teaching = readTeaching(*teaching);
        }
        if (auto const solutions = reader.optional("solutions")) {
            level_.solutions = readSolutions(*solutions);
        }
        if (auto const editor = reader.optional("editor")) {
            level_.editor = readEditor(*editor);
        }
        reader.finish();
        checkLevel(registry_, level_, entries.paths(), node.problems());
    }

private:
    static std::optional<int> readCount(JsonNode const& node) {
        if (node.value() == unlimitedWord) {
            return unlimitedCount;
        }
        if (!node.value().is_number()) {
            node.complainOfType(
                fmt::format("a whole number from 1 to {}, or \"{}\"", limits::toolboxCount, unlimitedWord));
            return std::nullopt;
        }
        auto const number = node.integer(1, limits::toolboxCount);
        return number ? std::optional(static_cast<int>(*number)) : std::nullopt;
    }

    void readToolboxEntry(JsonNode const& node) {
        MemberReader reader(node, "an object {\"part\", \"count\"} or {\"wire\"}");
        if (auto const wire = reader.optional("wire")) {
            reader.finish();
            if (level_.wires > 0) {
                node.complain("states wires again", "one entry for all wires");
            }
            level_.wires = readCount(*wire).value_or(0);
            return;
        }
        auto const part = reader.required("part", "the name of a part");
        auto const count = reader.optional("count");
        reader.finish();
        auto const name = part ? part->name("the name of a part") : std::nullopt;
        auto const number = count ? readCount(*count) : std::optional(1);
        if (!name || !number) {
            return;
        }
        if (auto const [first, isNew] = toolPaths_.try_emplace(*name, node.path()); !isNew) {
            node.complain(fmt::format("'{}' is already in {}", *name, first->second), "every part once");
        }
        level_.toolbox.push_back({*name, *number, node.path()});
    }

    Registry const& registry_;
    LevelFile& level_;
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
