#include "puzzle/goals/never_holds.hpp"

#include "physics/dynamics/properties/body.hpp"
#include "runtime/level/json/add_problem.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace trembler {
namespace {

/// Whom a selector can speak of.
struct Candidates {
    std::set<std::string> names;     ///< of objects of the level
    std::set<std::string> fromTools; ///< parts that the player may place
    std::size_t placed = 0;          ///< how many of them, at most
    bool it = false;

    [[nodiscard]] std::size_t size() const { return names.size() + placed + (it ? 1 : 0); }
};

class NeverFinder {
public:
    NeverFinder(LevelFile const& level, World const& world, Problems& problems)
        : level_(level), world_(world), problems_(problems) {
        for (LevelObject const& object : level.objects) {
            byPart_[object.part].push_back(&object.name);
        }
        for (ToolboxEntry const& entry : level.toolbox) {
            tools_[entry.part] += static_cast<std::size_t>(entry.count);
        }
    }

    void check(Condition const& condition) {
        switch (condition.kind) {
        case ConditionKind::touching:
            checkTouching(condition);
            break;
        case ConditionKind::moved:
            if (isFixed(condition.subject)) {
                complain(condition, "can never hold: what is fixed never moves", "something that can move");
            }
            break;
        case ConditionKind::inside:
            if (isFixed(condition.subject) && !anyInside(condition)) {
                complain(condition, "can never hold: what is fixed never gets there",
                         "something that can move, or an area around it");
            }
            break;
        case ConditionKind::count:
            checkCount(condition);
            break;
        default:
            break;
        }
        for (Condition const& child : condition.children) {
            check(child);
        }
    }

private:
    void add(Candidates& candidates, Selector const& selector) const {
        candidates.names.insert(selector.names.begin(), selector.names.end());
        candidates.it = candidates.it || selector.it;
        for (std::string const& part : selector.parts) {
            if (auto const made = byPart_.find(part); made != byPart_.end()) {
                for (std::string const* const name : made->second) {
                    candidates.names.insert(*name);
                }
            }
            auto const tool = tools_.find(part);
            if (tool != tools_.end() && candidates.fromTools.insert(part).second) {
                candidates.placed += tool->second;
            }
        }
    }

    void complain(Condition const& condition, std::string message, std::string expected) {
        addProblem(problems_, [&] {
            return level_.diagnostic(condition.path, std::move(message), std::move(expected));
        });
    }

    void checkTouching(Condition const& condition) {
        Candidates both;
        add(both, condition.subject);
        add(both, condition.object);
        if (both.size() == 1) {
            complain(condition, "can never hold: nothing touches itself", "two different objects");
        }
    }

    void checkCount(Condition const& condition) {
        Candidates counted;
        add(counted, condition.subject);
        auto const wanted = static_cast<std::size_t>(condition.number);
        if (condition.quantity != Quantity::atMost && wanted > counted.size()) {
            complain(
                condition,
                fmt::format("can never hold: it wants {} of what there can be {} of", wanted, counted.size()),
                "no more than the level has and the player may place");
        }
    }

    /// Whether all whom it speaks of are fixed.
    [[nodiscard]] bool isFixed(Selector const& selector) const {
        Candidates all;
        add(all, selector);
        return all.placed == 0 && !all.it && !all.names.empty() &&
               std::all_of(all.names.begin(), all.names.end(), [&](std::string const& name) {
                   ObjectId const id = world_.store().find(name);
                   return id.valid() && world_.find<Fixed>(id) != nullptr;
               });
    }

    [[nodiscard]] bool anyInside(Condition const& condition) const {
        Candidates all;
        add(all, condition.subject);
        return std::any_of(all.names.begin(), all.names.end(), [&](std::string const& name) {
            Position const* const position = world_.find<Position>(world_.store().find(name));
            return position != nullptr && condition.area.contains(position->value);
        });
    }

    LevelFile const& level_;
    World const& world_;
    Problems& problems_;
    std::map<std::string, std::vector<std::string const*>> byPart_; // names of objects
    std::map<std::string, std::size_t> tools_;                      // by part, how many
};

} // namespace

void complainIfNever(Condition const& condition, LevelFile const& level, World const& world,
                     Problems& problems) {
    NeverFinder(level, world, problems).check(condition);
}

} // namespace trembler
