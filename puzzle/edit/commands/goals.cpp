#include "puzzle/edit/commands/goals.hpp"

#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/commands/translations.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "puzzle/goals/conditions/table.hpp"
#include "puzzle/goals/reading/condition_outline.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler::edit {
namespace {

using Place = Json::json_pointer;

Place placeIn(std::string const& text) {
    try {
        return Place(text);
    } catch (Json::exception const&) {
        throw CommandError(fmt::format("'{}' is no place of a goal", text));
    }
}

/// The kind of a condition, if it contains others in that way and its value has that form; else nullptr.
ConditionOutline const* kindWith(InnerConditions inner, Json const& condition) {
    auto const all = conditionOutlines();
    auto const found = std::find_if(all.begin(), all.end(), [&](ConditionOutline const& one) {
        if (one.inner != inner || !condition.is_object() || !condition.contains(one.key)) {
            return false;
        }
        Json const& value = condition[one.key];
        return inner == InnerConditions::list     ? value.is_array()
               : inner == InnerConditions::member ? value.is_object() && value.contains(one.member)
                                                  : true;
    });
    return found == all.end() ? nullptr : &*found;
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
        if (auto const* const list = kindWith(InnerConditions::list, condition)) {
            line.takesMore = true;
            line.condition.erase(list->key);
            for (std::size_t i = 0; i < condition[list->key].size(); ++i) {
                inner.emplace_back(fmt::format("{}/{}/{}", place, list->key, i), &condition[list->key][i]);
            }
        } else if (auto const* const around = kindWith(InnerConditions::value, condition)) {
            line.condition.erase(around->key);
            inner.emplace_back(fmt::format("{}/{}", place, around->key), &condition[around->key]);
        } else if (auto const* const kind = kindWith(InnerConditions::member, condition)) {
            line.condition[kind->key].erase(kind->member);
            inner.emplace_back(fmt::format("{}/{}/{}", place, kind->key, kind->member),
                               &condition[kind->key][kind->member]);
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
    ConditionOutline const* const around = findOutline(at.back());
    if (around != nullptr && around->inner == InnerConditions::value) {
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
    for (ConditionKind const* const known : conditionKinds()) {
        if (known->key() != kind) {
            continue;
        }
        if (objects.size() < known->draftObjects()) {
            throw CommandError(objects.empty() ? "select an object that the goal is about"
                                               : "select the two objects that the goal is about");
        }
        return Json{{kind, known->draft({objects, areaJson(area)})}};
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
                if (auto const* const list = kindWith(InnerConditions::list, there)) {
                    there[list->key].push_back(condition);
                } else {
                    there = Json{{"all", Json::array({there, condition})}};
                }
            }};
}

Command wrapGoal(Json const& level, std::string const& place, std::string const& kind, GoalTree which) {
    mustHaveGoal(level, place, which);
    ConditionOutline const* const outline = findOutline(kind);
    bool const list = outline != nullptr && outline->inner == InnerConditions::list;
    if (!list && (outline == nullptr || outline->inner != InnerConditions::value)) {
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
                if (auto const* const list = kindWith(InnerConditions::list, there)) {
                    if (there[list->key].size() != 1) {
                        throw CommandError("only a single condition can take the place of its list");
                    }
                    inner = there[list->key][0];
                } else if (auto const* const around = kindWith(InnerConditions::value, there)) {
                    inner = there[around->key];
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
