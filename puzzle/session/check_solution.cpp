#include "puzzle/session/check_solution.hpp"

#include "runtime/level/json/add_problem.hpp"
#include "runtime/level/model/change_fault.hpp"
#include "runtime/population/birth_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace trembler {

void checkSolution(Registry const& registry, LevelFile const& level, LevelRun const& run,
                   Solution const& solution, Problems& problems) {
    auto const complain = [&](std::string const& path, std::string message, std::string expected) {
        addProblem(problems,
                   [&] { return level.diagnostic(solution, path, std::move(message), std::move(expected)); });
    };
    for (RecordedChange const& change : solution.changes) {
        if (auto const fault = faultIn(registry, run.world(), change)) {
            complain(change.path, fault->message, fault->expected);
        }
    }
    Store const& store = run.world().store();
    std::set<std::pair<ObjectId, ObjectId>> cut;
    for (RecordedInput const& input : solution.inputs) {
        for (std::string const* const name : {&input.object, &input.other}) {
            if (!name->empty() && !store.find(*name).valid() && !isBirthName(*name)) {
                complain(input.path, fmt::format("there is no object '{}'", *name),
                         "an object of the level, or one that the solution places");
            }
        }
        std::pair<ObjectId, ObjectId> const wire =
            std::minmax(store.find(input.object), store.find(input.other));
        if (input.kind != PlayerInput::Kind::cut || !wire.first.valid() || !wire.second.valid()) {
            continue;
        }
        if (!run.connectedAtStart(wire.first, wire.second)) {
            complain(input.path,
                     fmt::format("there is no wire between '{}' and '{}'", input.object, input.other),
                     "a pair of objects under \"connections\"");
        } else if (!cut.insert(wire).second) {
            complain(
                input.path,
                fmt::format("the wire between '{}' and '{}' has been cut before", input.object, input.other),
                "every wire once");
        }
    }
}

} // namespace trembler
