// Electricity: every registered detail level that says which objects are on, against Kirchhoff's laws.
//
// A level that is registered as a component and derives ElectricalState takes part by that alone. Properties
// that only some levels know, such as resistances, are stated if the registry knows them.
#include "game/accuracy/effect_clock.hpp"
#include "game/accuracy/ladder.hpp"
#include "game/accuracy/wiring.hpp"
#include "physics/electricity/calls.hpp"
#include "physics/electricity/properties.hpp"
#include "physics/electricity/register.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/level/build_world.hpp"
#include "runtime/level/read_level.hpp"
#include "runtime/population/population_resolver.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <memory>

namespace trembler::accuracy {
namespace {

/// The cable to be cut or mended in the next frame.
struct CableChange {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Cable change", "accuracy_cable_change", "A cable to cut or to mend."};
    ObjectId a;
    ObjectId b;
    bool mend = false;

    template <class Self, class Visitor>
    static void describe(Self&, Visitor&&) {}
};

class ElectricityFromAccuracy final
    : public Interaction<ElectricityFromAccuracy, ElectricityRole, Reads<CableChange>> {
public:
    static constexpr ComponentText text{
        .name = "Electricity <- Accuracy", .effect = "accuracy", .level = "", .work = "Cuts and mends."};
    using CalledFor = NeedsAll<CableChange>;
    void apply(Access& access) {
        for (CableChange const& change : access.read<CableChange>().values()) {
            if (change.mend) {
                access.call(AddConnection{{change.a, change.b, ConnectionCause::wire}});
            } else {
                access.call(RemoveConnection{{change.a, change.b, ConnectionCause::wire}});
            }
        }
    }
};

Registry const& electricityAlone() {
    static Registry const registry = [] {
        Registry made;
        registerRuntime(made);
        registerElectricity(made);
        made.component<ElectricityFromAccuracy>();
        return made;
    }();
    return registry;
}

/// Detail levels by cost, cheapest first.
std::vector<std::string> levels(Registry const& registry) {
    std::vector<ComponentText> found;
    for (Registration const& registration : registry.components()) {
        auto const& offers = registration.info->offers;
        if (std::find(offers.begin(), offers.end(), &propertyInfo<ElectricalState>()) != offers.end()) {
            found.push_back(registration.info->text);
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](ComponentText const& a, ComponentText const& b) { return a.cost < b.cost; });
    std::vector<std::string> names;
    for (ComponentText const& text : found) {
        names.emplace_back(text.level);
    }
    return names;
}

std::string nameOf(std::size_t circuit, std::size_t part) {
    return fmt::format("c{:04} p{:03}", circuit, part);
}

nlohmann::json propertiesOf(Registry const& registry, Part part, double ohm) {
    nlohmann::json properties{{"conductor", true}};
    auto const state = [&](char const* key, nlohmann::json value) {
        if (registry.objectProperty(key) != nullptr) {
            properties[key] = std::move(value);
        }
    };
    state("resistance", ohm);
    if (part == Part::source) {
        properties["electrical_source"] = true;
        state("emf", {{"voltage", sourceVolts}, {"internal_resistance", sourceOhms}});
    } else if (part == Part::earth) {
        properties["electrical_return"] = true;
    } else if (part == Part::lamp) {
        state("rated", {{"power", lampWatts}, {"voltage", sourceVolts}});
    }
    return properties;
}

LevelFile levelOf(Registry const& registry, std::vector<Wiring> const& circuits) {
    nlohmann::json level{{"version", levelVersion}, {"title", "circuits"}};
    level["objects"] = nlohmann::json::array();
    level["connections"] = nlohmann::json::array();
    for (std::size_t c = 0; c < circuits.size(); ++c) {
        for (std::size_t p = 0; p < circuits[c].parts.size(); ++p) {
            level["objects"].push_back(
                {{"name", nameOf(c, p)},
                 {"properties", propertiesOf(registry, circuits[c].parts[p], circuits[c].ohms[p])}});
        }
        for (auto const& [a, b] : circuits[c].cables) {
            level["connections"].push_back({nameOf(c, a), nameOf(c, b)});
        }
    }
    return readLevel(registry, JsonDocument::parse(level.dump(), "circuits"));
}

Rung measure(std::vector<Wiring> const& circuits, LevelFile const& file, std::string const& level,
             int frames) {
    WorldOptions options;
    options.detail["electricity"] = level;
    auto const world = buildWorld(electricityAlone(), file, PartLibrary{}, {}, options);
    for (int frame = 0; frame < 3; ++frame) {
        world->step();
    }
    Store& store = world->store();
    int lamps = 0;
    int wrong = 0;
    auto const& state = *world->find<ElectricalState>();
    for (std::size_t c = 0; c < circuits.size(); ++c) {
        std::vector<bool> const right = glowing(circuits[c]);
        for (std::size_t p = 0; p < right.size(); ++p) {
            if (circuits[c].parts[p] == Part::lamp) {
                ++lamps;
                wrong += state.isOn(store.find(nameOf(c, p))) != right[p] ? 1 : 0;
            }
        }
    }
    // What a change costs: in every frame one cable is cut, or that of the frame before is mended.
    EffectClock clock("electricity");
    ObjectId const world0 = store.find("world");
    for (int frame = 0; frame < frames; ++frame) {
        std::size_t const c = static_cast<std::size_t>(frame) / 2 % circuits.size();
        auto const& [a, b] =
            circuits[c].cables[static_cast<std::size_t>(frame) / 2 % circuits[c].cables.size()];
        store.column<CableChange>().set(world0,
                                        {store.find(nameOf(c, a)), store.find(nameOf(c, b)), frame % 2 == 1});
        world->step();
        clock.frame(*world);
    }
    return {level, clock.median(), lamps == 0 ? 0 : static_cast<double>(wrong) / lamps, {}, false, {}};
}

Ladder climbCircuits(std::vector<Wiring> const& circuits, std::string scene, Effort effort) {
    Ladder ladder{"",
                  std::move(scene),
                  "of the lamps",
                  "share of the lamps that are on though they are dark, or off though they glow; one cable "
                  "changes in every frame",
                  "Kirchhoff's laws by Gaussian elimination; a lamp glows from 1 % of its rated power on",
                  true,
                  {},
                  {}};
    LevelFile const file = levelOf(electricityAlone(), circuits);
    for (std::string const& level : levels(electricityAlone())) {
        ladder.rungs.push_back(measure(circuits, file, level, effort.brief ? 25 : 481));
    }
    ladder.remark =
        "The simpler levels are not worse at their own task: they are told who is connected, not who "
        "glows. This is what is lost when they are asked all the same.";
    return ladder;
}

} // namespace

void addElectricityPlans(std::vector<Plan>& plans) {
    plans.push_back({"electricity", [](Workshop const&, Effort effort) {
                         int const count = effort.brief ? 12 : 120;
                         return climbCircuits(schoolbook(count), fmt::format("{} schoolbook circuits", count),
                                              effort);
                     }});
    plans.push_back({"electricity", [](Workshop const&, Effort effort) {
                         int const count = effort.brief ? 8 : 100;
                         return climbCircuits(jumble(count, 24),
                                              fmt::format("{} circuits joined at random", count), effort);
                     }});
}

} // namespace trembler::accuracy
