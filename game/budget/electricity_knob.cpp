// The electricity knob: the detail level that the scene's circuits need, or a finer one. Coarser levels are
// not allowed: "on" and "off" have no small error.
#include "game/budget/knobs.hpp"
#include "game/budget/making_options.hpp"
#include "physics/electricity/properties/scene_level.hpp"

namespace trembler::budget {
namespace electricity_knob {
namespace {

constexpr std::string_view effect = "electricity";

} // namespace
} // namespace electricity_knob

std::optional<Knob> electricityKnob(World const& world) {
    using namespace electricity_knob;
    auto const levels = levelsOf(world, effect);
    auto const now = working(levels);
    if (!now) {
        return std::nullopt;
    }
    Knob knob;
    knob.effect = effect;
    knob.of = "of the lamps";
    knob.source = "A level that represents everything that the circuits state adds no error.";
    for (ComponentStatus const& level : levels) {
        std::string_view const name = level.info->text.level;
        Option option{
            std::string(name), {toLevel(effect, name)}, static_cast<double>(level.info->text.rank), {}, {}};
        bool const isNow = level.info == now->info;
        bool enough = false;
        for (ElectricalLevel const known : {ElectricalLevel::singleCable, ElectricalLevel::twoWire,
                                            ElectricalLevel::flow, ElectricalLevel::nodal}) {
            enough = enough || (name == nameOf(known) && isFaithful(known, world.store()));
        }
        if (!enough && !isNow) { // a level that the user has chosen stays allowed
            option.cannot = "it cannot represent everything that the circuits state";
        }
        if (isNow) {
            knob.current = knob.options.size();
        }
        knob.components.push_back(title(*level.info));
        knob.options.push_back(std::move(option));
    }
    return knob;
}

} // namespace trembler::budget
