// Complains about goals that can never come true in the level as a whole: see level_checks.hpp.
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/dynamics/properties/shape.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "puzzle/checks/level_checks.hpp"
#include "puzzle/goals/checking/candidates.hpp"
#include "puzzle/goals/read_goals.hpp"
#include "runtime/level/build/part_expander.hpp"
#include "runtime/level/json/add_problem.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {
namespace {

class HopelessCheck {
public:
    HopelessCheck(GameData const& data, LevelFile const& level, World const& world, Problems& problems)
        : data_(data), level_(level), world_(world), candidates_(level, world), problems_(problems) {}

    void check(Condition const& condition) {
        std::string_view const key = condition.kind->key();
        if (key == "on") {
            checkCurrent(condition);
        } else if (key == "touching") {
            checkMeeting(condition);
        } else if (key == "moved") {
            checkMoving(condition);
        } else if (key == "all") {
            checkContradiction(condition);
        }
        for (Condition const& child : condition.children) {
            check(child);
        }
    }

private:
    /// No current flows without a source, in the level or among the parts that may be placed.
    void checkCurrent(Condition const& condition) {
        auto const* const sources = world_.store().findColumn<ElectricalSource>();
        bool const source = (sources != nullptr && !sources->empty()) ||
                            std::any_of(level_.toolbox.begin(), level_.toolbox.end(),
                                        [&](ToolboxEntry const& tool) { return isSource(tool.part); });
        if (!source) {
            complain(condition.path, "no current can flow: there is no source of it",
                     "a battery or another source, in the level or in the toolbox");
        }
    }

    [[nodiscard]] bool isSource(std::string const& part) const {
        bool whole = true;
        PartExpander expander(data_.parts, [&](auto const&...) { whole = false; });
        LevelObject entry;
        entry.name = entry.part = part;
        StatementScope const nowhere;
        ExpandedEntry const expanded = expander.expand(entry, nowhere);
        return !whole ||
               std::any_of(expanded.objects.begin(), expanded.objects.end(), [](MadeObject const& made) {
                   return made.properties().find<ElectricalSource>() != nullptr;
               });
    }

    /// Two things that are fixed never come to touch one another.
    void checkMeeting(Condition const& condition) {
        if (candidates_.areFixed(condition.subject) && candidates_.areFixed(condition.object)) {
            complain(condition.path, "fixed objects never come to touch one another",
                     "something that can move");
        }
    }

    /// What has no body and no velocity stays where it is.
    void checkMoving(Condition const& condition) {
        Candidates const all = candidates_.of(condition.subject);
        bool const moves = all.it || all.placed > 0 || all.names.empty() ||
                           std::any_of(all.names.begin(), all.names.end(), [&](std::string const& name) {
                               ObjectId const id = world_.store().find(name);
                               return !id.valid() || world_.find<Shape>(id) != nullptr ||
                                      world_.find<Velocity>(id) != nullptr;
                           });
        if (!moves) {
            complain(condition.path, "an object without a shape never moves", "something that has a shape");
        }
    }

    /// A condition and its opposite do not hold at the same time.
    void checkContradiction(Condition const& condition) {
        auto const body = [&](Condition const& child) { return statement(child.path); };
        for (Condition const& child : condition.children) {
            nlohmann::json const stated = body(child);
            if (!stated.is_object() || stated.size() != 1 || !stated.contains("not")) {
                continue;
            }
            bool const opposed = std::any_of(
                condition.children.begin(), condition.children.end(),
                [&](Condition const& other) { return &other != &child && body(other) == stated["not"]; });
            if (opposed) {
                complain(child.path, "another of these goals demands the opposite",
                         "goals that can hold at the same time");
            }
        }
    }

    /// What the file states at a place in its goals or its task.
    [[nodiscard]] nlohmann::json statement(std::string const& path) const {
        constexpr std::string_view goals = "/goals";
        constexpr std::string_view task = "/task";
        bool const inGoals = path.starts_with(goals);
        if (!inGoals && !path.starts_with(task)) {
            return {};
        }
        nlohmann::json const& tree = inGoals ? level_.goals : level_.task;
        nlohmann::json::json_pointer const at(path.substr((inGoals ? goals : task).size()));
        return tree.contains(at) ? tree.at(at) : nlohmann::json();
    }

    void complain(std::string path, std::string message, std::string expected) {
        addProblem(problems_, [&] {
            return level_.diagnostic(std::move(path), fmt::format("can never hold: {}", message),
                                     std::move(expected));
        });
    }

    GameData const& data_;
    LevelFile const& level_;
    World const& world_;
    CandidateFinder candidates_;
    Problems& problems_;
};

} // namespace

void complainAboutHopeless(GameData const& data, LevelFile const& level, World const& world,
                           Problems& problems) {
    if (!level.mods.empty()) { // a mod's scripts may do anything
        return;
    }
    Problems ignored; // goals and task have been read before
    for (auto const& condition : {readGoals(level, ignored), readTask(level, ignored)}) {
        if (condition) {
            HopelessCheck(data, level, world, problems).check(*condition);
        }
    }
}

} // namespace trembler
