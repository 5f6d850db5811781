#include "puzzle/edit/commands/goals.hpp"

#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/commands/translations.hpp"
#include "puzzle/edit/tree/tree_access.hpp"

#include <fmt/format.h>

#include <array>

namespace trembler::edit {
namespace {

using Place = Json::json_pointer;

constexpr std::array<char const*, 3> listKinds{"all", "any", "sequence"};

Place placeIn(std::string const& text) {
    try {
        return Place(text);
    } catch (Json::exception const&) {
        throw CommandError(fmt::format("'{}' is no place of a goal", text));
    }
}

/// The list of inner conditions, if the condition is one.
char const* listKindOf(Json const& condition) {
    for (char const* const kind : listKinds) {
        if (condition.is_object() && condition.contains(kind) && condition[kind].is_array()) {
            return kind;
        }
    }
    return nullptr;
}

Json& conditionAt(Json& level, std::string const& place, GoalTree tree) {
    Place const at = placeIn(place);
    auto const goals = level.find(keyOf(tree));
    if (goals == level.end() || !goals->contains(at) || !(*goals)[at].is_object()) {
        throw CommandError("there is no such goal");
    }
    return (*goals)[at];
}

void mustHaveGoal(Json const& level, std::string const& place, GoalTree tree) {
    Place const at = placeIn(place);
    auto const goals = level.find(keyOf(tree));
    if (goals == level.end() || !goals->contains(at) || !(*goals)[at].is_object()) {
        throw CommandError("there is no such goal");
    }
}

void addLines(Json const& condition, std::string const& place, std::size_t depth,
              std::vector<GoalLine>& lines) {
    GoalLine line{place, depth, {}, condition, false};
    std::vector<std::pair<std::string, Json const*>> inner;
    if (condition.is_object()) {
        for (auto const& [key, value] : condition.items()) {
            if (key != "for" && key != "id" && key != "text" && line.kind.empty()) {
                line.kind = key;
            }
        }
        if (char const* const kind = listKindOf(condition)) {
            line.takesMore = true;
            line.condition.erase(kind);
            for (std::size_t i = 0; i < condition[kind].size(); ++i) {
                inner.emplace_back(fmt::format("{}/{}/{}", place, kind, i), &condition[kind][i]);
            }
        } else if (condition.contains("not")) {
            line.condition.erase("not");
            inner.emplace_back(place + "/not", &condition["not"]);
        } else if (auto const count = condition.find("count");
                   count != condition.end() && count->is_object() && count->contains("that")) {
            line.condition["count"].erase("that");
            inner.emplace_back(place + "/count/that", &(*count)["that"]);
        }
    }
    lines.push_back(std::move(line));
    for (auto const& [where, child] : inner) {
        addLines(*child, where, depth + 1, lines);
    }
}

void removeAt(Json& level, std::string const& place, GoalTree tree) {
    if (place.empty()) {
        level.erase(keyOf(tree));
        return;
    }
    Json& goals = level[keyOf(tree)];
    Place const at = placeIn(place);
    Place const parent = at.parent_pointer();
    if (at.back() == "not") {
        removeAt(level, parent.to_string(), tree);
    } else if (goals[parent].is_array()) {
        goals[parent].erase(static_cast<std::size_t>(std::stoul(at.back())));
        if (goals[parent].empty()) {
            removeAt(level, parent.parent_pointer().to_string(), tree);
        }
    } else {
        throw CommandError("what is counted cannot be removed; change it, or remove the count");
    }
}

} // namespace

char const* keyOf(GoalTree tree) {
    return tree == GoalTree::goals ? "goals" : "task";
}

std::vector<GoalLine> goalLines(Json const& level, GoalTree tree) {
    std::vector<GoalLine> lines;
    auto const goals = level.is_object() ? level.find(keyOf(tree)) : level.end();
    if (goals != level.end()) {
        addLines(*goals, "", 0, lines);
    }
    return lines;
}

Json newCondition(std::string const& kind, std::vector<std::string> const& objects, Area const& area) {
    auto const object = [&](std::size_t index) {
        if (index >= objects.size()) {
            throw CommandError(index == 0 ? "select an object that the goal is about"
                                          : "select the two objects that the goal is about");
        }
        return objects[index];
    };
    if (kind == "inside") {
        return Json{{kind, {{"object", object(0)}, {"area", areaJson(area)}}}};
    }
    if (kind == "touching") {
        return Json{{kind, Json::array({object(0), object(1)})}};
    }
    if (kind == "on" || kind == "off") {
        return Json{{kind, object(0)}};
    }
    if (kind == "moved") {
        return Json{{kind, {{"object", object(0)}, {"by", 1}}}};
    }
    if (kind == "count") {
        object(0);
        return Json{{kind,
                     {{"of", objects},
                      {"at_least", 1},
                      {"that", {{"inside", {{"object", "it"}, {"area", areaJson(area)}}}}}}}};
    }
    if (kind == "not") {
        return Json{{kind, newCondition("moved", objects, area)}};
    }
    if (kind == "all" || kind == "any" || kind == "sequence") {
        return Json{{kind, Json::array({newCondition("moved", objects, area)})}};
    }
    throw CommandError(fmt::format("there is no kind of goal '{}'", kind));
}

Command addGoal(Json const& level, std::string const& place, Json const& condition, GoalTree which) {
    char const* const key = keyOf(which);
    if (which == GoalTree::task &&
        (!level.is_object() || level.value("demonstration", Json()) != Json(true))) {
        throw CommandError("only a demonstration has a task");
    }
    if (level.contains(key)) {
        mustHaveGoal(level, place, which);
    } else if (!place.empty()) {
        throw CommandError("there is no such goal");
    }
    return {"Add goal", [place, condition, which, key](Json& tree) {
                if (!tree.contains(key)) {
                    setLevelMember(tree, key, condition);
                    return;
                }
                Json& there = conditionAt(tree, place, which);
                if (char const* const kind = listKindOf(there)) {
                    there[kind].push_back(condition);
                } else {
                    there = Json{{"all", Json::array({there, condition})}};
                }
            }};
}

Command wrapGoal(Json const& level, std::string const& place, std::string const& kind, GoalTree which) {
    mustHaveGoal(level, place, which);
    bool const list = kind == "all" || kind == "any" || kind == "sequence";
    if (!list && kind != "not") {
        throw CommandError(fmt::format("'{}' takes no conditions", kind));
    }
    return {fmt::format("Put goal into '{}'", kind), [=](Json& tree) {
                Json& there = conditionAt(tree, place, which);
                Json inner = there;
                there = Json::object();
                there[kind] = list ? Json::array({std::move(inner)}) : std::move(inner);
            }};
}

Command unwrapGoal(Json const& level, std::string const& place, GoalTree which) {
    mustHaveGoal(level, place, which);
    return {"Take goal out", [place, which](Json& tree) {
                Json& there = conditionAt(tree, place, which);
                Json inner;
                if (char const* const kind = listKindOf(there)) {
                    if (there[kind].size() != 1) {
                        throw CommandError("only a single condition can take the place of its list");
                    }
                    inner = there[kind][0];
                } else if (there.contains("not")) {
                    inner = there["not"];
                } else {
                    throw CommandError("this goal contains no other one");
                }
                there = std::move(inner);
            }};
}

Command removeGoal(Json const& level, std::string const& place, GoalTree which) {
    mustHaveGoal(level, place, which);
    return {"Remove goal", [place, which](Json& tree) {
                mustHaveGoal(tree, place, which);
                removeAt(tree, place, which);
            }};
}

Command changeGoal(Json const& level, std::string const& place, Json const& condition, GoalTree which) {
    mustHaveGoal(level, place, which);
    if (!condition.is_object()) {
        throw CommandError("a goal is an object");
    }
    return {"Change goal", [=](Json& tree) { conditionAt(tree, place, which) = condition; }};
}

Command setGoalOption(Json const& level, std::string const& place, std::string const& key, Json const& value,
                      GoalTree which) {
    mustHaveGoal(level, place, which);
    if (key != "for" && key != "id" && key != "text") {
        throw CommandError(fmt::format("a goal has no '{}'", key));
    }
    return {value.is_null() ? fmt::format("Remove '{}' of goal", key)
                            : fmt::format("Change '{}' of goal", key),
            [=](Json& tree) {
                Json& there = conditionAt(tree, place, which);
                std::string const before = textOf(there, "id");
                if (value.is_null()) {
                    there.erase(key);
                } else {
                    there[key] = value;
                }
                std::string const now = textOf(there, "id");
                if (!before.empty() && !now.empty() && now != before) {
                    translationsRenamedGoal(tree, before, now);
                }
            }};
}

Command setGoalArea(Json const& level, std::string const& place, Area const& area, GoalTree which) {
    mustHaveGoal(level, place, which);
    return {"Change area of goal", [place, which, made = areaJson(area)](Json& tree) {
                Json& there = conditionAt(tree, place, which);
                for (auto const& item : there.items()) {
                    if (item.value().is_object() && item.value().contains("area")) {
                        item.value()["area"] = made;
                        return;
                    }
                }
                throw CommandError("this goal has no area");
            }};
}

Command moveGoal(Json const& level, std::string const& place, std::size_t to, GoalTree which) {
    mustHaveGoal(level, place, which);
    return {"Move goal", [place, which, to](Json& tree) {
                Place const at = placeIn(place);
                Json* const around = place.empty() ? nullptr : &tree[keyOf(which)][at.parent_pointer()];
                if (around == nullptr || !around->is_array() || to >= around->size()) {
                    throw CommandError("the goal cannot be moved there");
                }
                auto const from = static_cast<std::size_t>(std::stoul(at.back()));
                Json moved = (*around)[from];
                around->erase(from);
                auto& list = around->get_ref<Json::array_t&>();
                list.insert(list.begin() + static_cast<std::ptrdiff_t>(to), std::move(moved));
            }};
}

} // namespace trembler::edit
