#include "puzzle/edit/commands/editor_state.hpp"

#include "puzzle/edit/commands/objects.hpp"
#include "puzzle/edit/tree/tree_access.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler::edit {
namespace {

constexpr char const* editorKey = "editor";

Json const* stateList(Json const& level, char const* key) {
    auto const editor = level.is_object() ? level.find(editorKey) : level.end();
    return editor == level.end() ? nullptr : findList(*editor, key);
}

bool namesContain(Json const& list, std::string const& name) {
    return std::any_of(list.begin(), list.end(),
                       [&](Json const& entry) { return entry.is_string() && entry == name; });
}

bool isListed(Json const& level, char const* key, std::string const& name) {
    Json const* const list = stateList(level, key);
    return list != nullptr && namesContain(*list, name);
}

/// Removes names that no object has, groups of fewer than two, and empty lists.
void tidyState(Json& level) {
    auto const at = level.find(editorKey);
    if (at == level.end() || !at->is_object()) {
        return;
    }
    std::vector<std::string> const all = objectNames(level);
    std::set<std::string> const known(all.begin(), all.end());
    auto const keepKnown = [&](Json& list) {
        Json kept = Json::array();
        for (Json const& name : list) {
            if (name.is_string() && known.contains(name.get<std::string>())) {
                kept.push_back(name);
            }
        }
        list = std::move(kept);
    };
    Json& editor = *at;
    for (char const* const key : {"locked", "hidden"}) {
        if (editor.contains(key) && editor[key].is_array()) {
            keepKnown(editor[key]);
            dropIfEmpty(editor, key);
        }
    }
    if (editor.contains("groups") && editor["groups"].is_array()) {
        Json groups = Json::array();
        for (Json& group : editor["groups"]) {
            if (group.is_array()) {
                keepKnown(group);
                if (group.size() > 1) {
                    groups.push_back(std::move(group));
                }
            }
        }
        editor["groups"] = std::move(groups);
        dropIfEmpty(editor, "groups");
    }
    dropIfEmpty(level, editorKey);
}

Json& stateIn(Json& level) {
    return objectIn(level, editorKey);
}

Json& stateListIn(Json& level, char const* key) {
    Json& editor = stateIn(level);
    if (!editor.contains(key)) {
        static std::vector<std::string> const order{"groups", "locked", "hidden"};
        setMember(editor, key, Json::array(), order);
    }
    if (!editor[key].is_array()) {
        throw CommandError(fmt::format("\"{}\" under \"editor\" is no list", key));
    }
    return editor[key];
}

Command markObjects(Json const& level, std::vector<std::string> const& names, char const* key, bool mark,
                    char const* what) {
    mustHaveObjects(level, names);
    return {fmt::format(fmt::runtime(what), objectsInWords(names)),
            [names, key, mark](Json& tree) {
                Json& list = stateListIn(tree, key);
                for (std::string const& name : names) {
                    if (mark && !namesContain(list, name)) {
                        list.push_back(name);
                    } else if (!mark) {
                        list.erase(std::remove(list.begin(), list.end(), Json(name)), list.end());
                    }
                }
                tidyState(tree);
            },
            names};
}

/// Takes objects out of their groups.
void leaveGroups(Json& level, std::vector<std::string> const& names) {
    for (Json& group : stateListIn(level, "groups")) {
        for (std::string const& name : names) {
            if (group.is_array()) {
                group.erase(std::remove(group.begin(), group.end(), Json(name)), group.end());
            }
        }
    }
}

} // namespace

bool isLocked(Json const& level, std::string const& name) {
    return isListed(level, "locked", name);
}

bool isHidden(Json const& level, std::string const& name) {
    return isListed(level, "hidden", name);
}

std::vector<std::string> groupOf(Json const& level, std::string const& name) {
    if (Json const* const groups = stateList(level, "groups")) {
        for (Json const& group : *groups) {
            if (!group.is_array() || !namesContain(group, name)) {
                continue;
            }
            std::vector<std::string> members;
            for (std::string const& object : objectNames(level)) {
                if (namesContain(group, object)) {
                    members.push_back(object);
                }
            }
            return members;
        }
    }
    return {name};
}

std::vector<std::string> withGroups(Json const& level, std::vector<std::string> const& names) {
    std::vector<std::string> all;
    std::set<std::string> known;
    for (std::string const& name : names) {
        for (std::string const& member : groupOf(level, name)) {
            if (known.insert(member).second) {
                all.push_back(member);
            }
        }
    }
    return all;
}

std::vector<std::string> unlocked(Json const& level, std::vector<std::string> const& names) {
    std::vector<std::string> free;
    std::copy_if(names.begin(), names.end(), std::back_inserter(free),
                 [&](std::string const& name) { return !isLocked(level, name); });
    return free;
}

Command groupObjects(Json const& level, std::vector<std::string> const& names) {
    mustHaveObjects(level, names);
    if (std::set<std::string>(names.begin(), names.end()).size() < 2) {
        throw CommandError("a group needs at least two objects");
    }
    return {fmt::format("Group {}", objectsInWords(names)),
            [names](Json& tree) {
                leaveGroups(tree, names);
                Json group = Json::array();
                for (std::string const& name : names) {
                    if (!namesContain(group, name)) {
                        group.push_back(name);
                    }
                }
                stateListIn(tree, "groups").push_back(std::move(group));
                tidyState(tree);
            },
            names};
}

Command ungroupObjects(Json const& level, std::vector<std::string> const& names) {
    mustHaveObjects(level, names);
    return {fmt::format("Ungroup {}", objectsInWords(names)),
            [names](Json& tree) {
                Json& groups = stateListIn(tree, "groups");
                groups.erase(std::remove_if(groups.begin(), groups.end(),
                                            [&](Json const& group) {
                                                return std::any_of(
                                                    names.begin(), names.end(), [&](std::string const& name) {
                                                        return group.is_array() && namesContain(group, name);
                                                    });
                                            }),
                             groups.end());
                tidyState(tree);
            },
            names};
}

Command lockObjects(Json const& level, std::vector<std::string> const& names, bool lock) {
    return markObjects(level, names, "locked", lock, lock ? "Lock {}" : "Unlock {}");
}

Command hideObjects(Json const& level, std::vector<std::string> const& names, bool hide) {
    return markObjects(level, names, "hidden", hide, hide ? "Hide {}" : "Show {}");
}

void tidyEditorState(Json& level) {
    tidyState(level);
}

} // namespace trembler::edit
