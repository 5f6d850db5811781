// {"on": O}: an object is part of a working circuit.
#include "physics/electricity/properties/electrical.hpp"
#include "puzzle/goals/checking/whole_level.hpp"
#include "puzzle/goals/conditions/circuit.hpp"
#include "puzzle/goals/conditions/kinds.hpp"
#include "puzzle/goals/judging/condition_state.hpp"
#include "runtime/level/build/part_expander.hpp"

#include <algorithm>

namespace trembler::conditions {
namespace {

/// Whether objects made from the part include a source of current; true if its pieces are not all known.
bool isSource(PartLibrary const& parts, std::string const& part) {
    bool whole = true;
    PartExpander expander(parts, [&](auto const&...) { whole = false; });
    LevelObject entry;
    entry.name = entry.part = part;
    StatementScope const nowhere;
    ExpandedEntry const expanded = expander.expand(entry, nowhere);
    return !whole ||
           std::any_of(expanded.objects.begin(), expanded.objects.end(), [](MadeObject const& made) {
               return made.properties().find<ElectricalSource>() != nullptr;
           });
}

class OnCondition final : public CircuitCondition {
public:
    constexpr OnCondition() : CircuitCondition("on", true) {}

    [[nodiscard]] Standing judge(ConditionState& state, World const& world) const override {
        return {std::any_of(state.subjects().begin(), state.subjects().end(),
                            [&](ObjectId id) { return isOn(world, id); }),
                0};
    }

    /// No current flows without a source, in the level or among the parts that may be placed.
    [[nodiscard]] std::vector<Impossibility> whyHopeless(Condition const& /*condition*/,
                                                         WholeLevel const& level) const override {
        auto const* const sources = level.world.store().findColumn<ElectricalSource>();
        auto const& toolbox = level.level.toolbox;
        bool const source = (sources != nullptr && !sources->empty()) ||
                            std::any_of(toolbox.begin(), toolbox.end(), [&](ToolboxEntry const& tool) {
                                return isSource(level.parts, tool.part);
                            });
        if (source) {
            return {};
        }
        return {{"no current can flow: there is no source of it",
                 "a battery or another source, in the level or in the toolbox"}};
    }
};

} // namespace

ConditionKind const& on() {
    static OnCondition const kind;
    return kind;
}

} // namespace trembler::conditions
