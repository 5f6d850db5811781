#include "puzzle/edit/commands/goals.hpp"

#include "puzzle/edit/commands/contents.hpp"
#include "puzzle/edit/tree/tree_access.hpp"

#include <fmt/format.h>

#include <array>

namespace trembler::edit {
namespace {

using Place = Json::json_pointer;

constexpr char const* goalsKey = "goals";
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

Json& conditionAt(Json& level, std::string const& place) {
    Place const at = placeIn(place);
    auto const goals = level.find(goalsKey);
    if (goals == level.end() || !goals->contains(at) || !(*goals)[at].is_object()) {
        throw CommandError("there is no such goal");
    }
    return (*goals)[at];
}

void mustHaveGoal(Json const& level, std::string const& place) {
    Place const at = placeIn(place);
    auto const goals = level.find(goalsKey);
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

void removeAt(Json& level, std::string const& place) {
    if (place.empty()) {
        level.erase(goalsKey);
        return;
    }
    Json& goals = level[goalsKey];
    Place const at = placeIn(place);
    Place const parent = at.parent_pointer();
    if (at.back() == "not") {
        removeAt(level, parent.to_string());
    } else if (goals[parent].is_array()) {
        goals[parent].erase(static_cast<std::size_t>(std::stoul(at.back())));
        if (goals[parent].empty()) {
            removeAt(level, parent.parent_pointer().to_string());
        }
    } else {
        throw CommandError("what is counted cannot be removed; change it, or remove the count");
    }
}

} // namespace

std::vector<GoalLine> goalLines(Json const& level) {
    std::vector<GoalLine> lines;
    auto const goals = level.is_object() ? level.find(goalsKey) : level.end();
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

Command addGoal(Json const& level, std::string const& place, Json const& condition) {
    if (level.contains(goalsKey)) {
        mustHaveGoal(level, place);
    } else if (!place.empty()) {
        throw CommandError("there is no such goal");
    }
    return {"Add goal", [place, condition](Json& tree) {
                if (!tree.contains(goalsKey)) {
                    setLevelMember(tree, goalsKey, condition);
                    return;
                }
                Json& there = conditionAt(tree, place);
                if (char const* const kind = listKindOf(there)) {
                    there[kind].push_back(condition);
                } else {
                    there = Json{{"all", Json::array({there, condition})}};
                }
            }};
}

Command wrapGoal(Json const& level, std::string const& place, std::string const& kind) {
    mustHaveGoal(level, place);
    bool const list = kind == "all" || kind == "any" || kind == "sequence";
    if (!list && kind != "not") {
        throw CommandError(fmt::format("'{}' takes no conditions", kind));
    }
    return {fmt::format("Put goal into '{}'", kind), [=](Json& tree) {
                Json& there = conditionAt(tree, place);
                Json inner = there;
                there = Json::object();
                there[kind] = list ? Json::array({std::move(inner)}) : std::move(inner);
            }};
}

Command unwrapGoal(Json const& level, std::string const& place) {
    mustHaveGoal(level, place);
    return {"Take goal out", [place](Json& tree) {
                Json& there = conditionAt(tree, place);
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

Command removeGoal(Json const& level, std::string const& place) {
    mustHaveGoal(level, place);
    return {"Remove goal", [place](Json& tree) {
                mustHaveGoal(tree, place);
                removeAt(tree, place);
            }};
}

Command changeGoal(Json const& level, std::string const& place, Json const& condition) {
    mustHaveGoal(level, place);
    if (!condition.is_object()) {
        throw CommandError("a goal is an object");
    }
    return {"Change goal", [=](Json& tree) { conditionAt(tree, place) = condition; }};
}

Command setGoalOption(Json const& level, std::string const& place, std::string const& key,
                      Json const& value) {
    mustHaveGoal(level, place);
    if (key != "for" && key != "id" && key != "text") {
        throw CommandError(fmt::format("a goal has no '{}'", key));
    }
    return {value.is_null() ? fmt::format("Remove '{}' of goal", key)
                            : fmt::format("Change '{}' of goal", key),
            [=](Json& tree) {
                Json& there = conditionAt(tree, place);
                if (value.is_null()) {
                    there.erase(key);
                } else {
                    there[key] = value;
                }
            }};
}

Command setGoalArea(Json const& level, std::string const& place, Area const& area) {
    mustHaveGoal(level, place);
    return {"Change area of goal", [place, made = areaJson(area)](Json& tree) {
                Json& there = conditionAt(tree, place);
                for (auto const& item : there.items()) {
                    if (item.value().is_object() && item.value().contains("area")) {
                        item.value()["area"] = made;
                        return;
                    }
                }
                throw CommandError("this goal has no area");
            }};
}

Command moveGoal(Json const& level, std::string const& place, std::size_t to) {
    mustHaveGoal(level, place);
    return {"Move goal", [place, to](Json& tree) {
                Place const at = placeIn(place);
                Json* const around = place.empty() ? nullptr : &tree[goalsKey][at.parent_pointer()];
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
