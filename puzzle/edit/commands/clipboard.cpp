#include "puzzle/edit/commands/clipboard.hpp"

#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/text/lay_out.hpp"
#include "puzzle/edit/tree/subset.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/model/level.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler::edit {
namespace {

constexpr Vec2 besidesCopied{0.2, -0.2}; // m

/// The subset in a text from the clipboard; null if it is none.
Json subsetIn(std::string const& text) {
    try {
        auto const document = JsonDocument::parse(text, "clipboard"); // checks size, depth and repeated keys
        Json subset = Json::parse(document->text());
        if (textOf(subset, "trembler") != "objects" || subset.value("version", Json()) != levelVersion) {
            return {};
        }
        Json const* const objects = findList(subset, "objects");
        bool const named = objects != nullptr && !objects->empty() &&
                           std::all_of(objects->begin(), objects->end(),
                                       [](Json const& entry) { return !textOf(entry, "name").empty(); });
        for (char const* const key : {"joints", "connections", "groups"}) {
            if (subset.contains(key) && !subset[key].is_array()) {
                return {};
            }
        }
        return named ? subset : Json();
    } catch (InputError const&) {
        return {};
    }
}

Vec2 middleOf(Json const& objects) {
    Vec2 low = placeOf(objects.front());
    Vec2 high = low;
    for (Json const& entry : objects) {
        Vec2 const at = placeOf(entry);
        low = {std::min(low.x, at.x), std::min(low.y, at.y)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
    return (low + high) * 0.5;
}

/// Whether an object of the level lies exactly where one of these lies.
bool isTaken(Json const& level, Json const& objects, Vec2 by) {
    Json const* const list = findList(level, "objects");
    return list != nullptr && std::any_of(list->begin(), list->end(), [&](Json const& there) {
               return std::any_of(objects.begin(), objects.end(), [&](Json const& entry) {
                   return length(placeOf(there) - placeOf(entry) - by) < 1e-6;
               });
           });
}

} // namespace

std::string copiedText(GameData const& data, Json const& level, std::vector<std::string> const& names) {
    Json copied{{"trembler", "objects"}, {"version", levelVersion}};
    Json const subset = subsetOf(data, level, names);
    for (auto const& [key, list] : subset.items()) {
        copied[key] = list;
    }
    return layOutFile(copied);
}

bool canPaste(std::string const& text) {
    return !subsetIn(text).is_null();
}

Command pasteText(GameData const& data, Json const& level, std::string const& text, std::optional<Vec2> at) {
    Json subset = subsetIn(text);
    if (subset.is_null()) {
        throw CommandError("the clipboard holds no objects of a level");
    }
    std::vector<std::string> const made = makeUnique(data, subset, level);
    Vec2 by;
    if (at) {
        by = *at - middleOf(subset["objects"]);
    } else {
        while (isTaken(level, subset["objects"], by)) {
            by += besidesCopied;
        }
    }
    shiftSubset(subset, by);
    return {fmt::format("Paste {}", objectsInWords(made)), [subset](Json& tree) { addSubset(tree, subset); },
            made};
}

Command cutObjects(GameData const& data, Json const& level, std::vector<std::string> const& names) {
    Command cut = removeObjects(data, level, names);
    cut.name.replace(0, std::string_view("Remove").size(), "Cut");
    return cut;
}

} // namespace trembler::edit
