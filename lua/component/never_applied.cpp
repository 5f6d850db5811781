#include "lua/component/never_applied.hpp"

#include "lua/attach/scripts_property.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace trembler::lua {
namespace {

/// The objects that have all of the properties and, if `attached`, name the script. A script that is not
/// attached states at least one property.
class Selection {
public:
    Selection(Script const& script, World const& world) : script_(script), store_(world.store()) {}

    [[nodiscard]] std::size_t count(std::vector<std::size_t> const& needed, bool attached) const {
        ColumnBase const* const column =
            store_.findColumn(attached ? propertyInfo<Scripts>() : *script_.reads[needed.front()].info);
        if (column == nullptr) {
            return 0;
        }
        return static_cast<std::size_t>(
            std::count_if(column->owners().begin(), column->owners().end(),
                          [&](ObjectId id) { return hasAll(id, needed) && (!attached || names(id)); }));
    }
    [[nodiscard]] std::string namesOf(std::vector<std::size_t> const& needed) const {
        std::vector<std::string> all;
        for (std::size_t const read : needed) {
            all.push_back(script_.reads[read].name);
        }
        if (all.size() == 1) {
            return "'" + all.front() + "'";
        }
        std::string text;
        for (std::size_t i = 0; i < all.size(); ++i) {
            text += fmt::format("{}'{}'", i == 0 ? "" : i + 1 == all.size() ? " and " : ", ", all[i]);
        }
        return text;
    }

private:
    [[nodiscard]] bool hasAll(ObjectId id, std::vector<std::size_t> const& needed) const {
        return std::all_of(needed.begin(), needed.end(), [&](std::size_t read) {
            ColumnBase const* const column = store_.findColumn(*script_.reads[read].info);
            return column != nullptr && column->has(id);
        });
    }
    [[nodiscard]] bool names(ObjectId id) const {
        auto const* const column = store_.findColumn<Scripts>();
        Scripts const* const scripts = column == nullptr ? nullptr : column->find(id);
        return scripts != nullptr &&
               std::any_of(scripts->uses.begin(), scripts->uses.end(),
                           [&](ScriptUse const& use) { return use.script == script_.manifest.name; });
    }

    Script const& script_;
    Store const& store_;
};

/// Why the world has not constructed it.
std::string whyAbsent(Script const& script, Choice const& choice) {
    switch (choice.reason) {
    case ChoiceReason::noObjects:
        if (choice.property == &propertyInfo<Scripts>()) {
            return fmt::format("no object names '{}' under \"scripts\"", script.manifest.name);
        }
        return fmt::format("no object has '{}'",
                           choice.property == nullptr ? "what it needs" : choice.property->text.name);
    case ChoiceReason::noResolver:
        return fmt::format("nothing in the level needs {}, which it calls", script.manifest.calls);
    case ChoiceReason::noProvider:
        return fmt::format("no simulation of the level computes '{}', which it reads",
                           choice.property == nullptr ? "what it reads" : choice.property->text.name);
    default:
        return "the level does not need it";
    }
}

} // namespace

NeverApplied whyNeverApplied(Script const& script, World const& world) {
    Manifest const& manifest = script.manifest;
    for (ComponentStatus const& status : world.status()) {
        if (status.info->text.name == manifest.name && !status.choice.chosen()) {
            return {status.choice.reason == ChoiceReason::noObjects ? 0 : 1,
                    whyAbsent(script, status.choice)};
        }
    }
    Selection const selection(script, world);
    bool const pairs = manifest.application == Application::pairs;
    if (manifest.attached && selection.count({}, true) == 0) {
        return {2, fmt::format("no object names '{}' under \"scripts\"", manifest.name)};
    }
    if (manifest.application != Application::once && selection.count(script.first, manifest.attached) == 0) {
        std::string_view const who = manifest.attached ? "no object that names it has" : "no object has";
        return {3, fmt::format("{} {}{}", who, selection.namesOf(script.first),
                               script.first.size() > 1 ? " at once" : "")};
    }
    if (pairs && selection.count(script.second, false) == 0) {
        return {4, fmt::format("no object has {}{}, as the second of a pair must",
                               selection.namesOf(script.second), script.second.size() > 1 ? " at once" : "")};
    }
    if (pairs && manifest.touching) {
        return {5, "no two of its objects touch each other"};
    }
    if (pairs) {
        return {5, manifest.withinParameter.empty()
                       ? fmt::format("no two of its objects come within {} m of each other", manifest.within)
                       : fmt::format("no two of its objects come as near to each other as '{}' states",
                                     manifest.withinParameter)};
    }
    return {6, "it has had no turn"};
}

} // namespace trembler::lua
