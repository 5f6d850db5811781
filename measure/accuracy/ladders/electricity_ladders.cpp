// Electricity ladders: every registered detail level that determines which objects are on, against
// Kirchhoff's laws and ngspice.
//
// Any registered level that derives ElectricalState is measured automatically. Properties that only some
// levels use, such as resistances, are set if the registry has them.
#include "measure/accuracy/ladder.hpp"
#include "measure/accuracy/ladders/effect_clock.hpp"
#include "measure/accuracy/ladders/ngspice.hpp"
#include "measure/accuracy/ladders/wiring.hpp"
#include "physics/electricity/analyses/spice.hpp"
#include "physics/electricity/calls.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/quantities.hpp"
#include "physics/electricity/register.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/population/population_resolver.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace trembler::accuracy {
namespace {

/// The cable to be cut or repaired in the next frame.
struct CableChange {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Cable change", "accuracy_cable_change", "A cable to cut or to mend.",
                                       PropertyPlace::hidden};
    ObjectId a;
    ObjectId b;
    bool mend = false;
};

class ElectricityFromAccuracy final
    : public Interaction<ElectricityFromAccuracy, ElectricityRole, Reads<CableChange>> {
public:
    static constexpr ComponentText text{
        .name = "Electricity <- Accuracy", .effect = "accuracy", .level = "", .work = "Cuts and mends."};
    using Activation = NeedsAll<CableChange>;
    void apply(Access& access) {
        for (CableChange const& change : access.read<CableChange>().values()) {
            if (change.mend) {
                access.call(AddConnection{{change.a, change.b}});
            } else {
                access.call(CutWire{change.a, change.b}); // the original cable, or the one that repaired it
                access.call(RemoveConnection{{change.a, change.b}});
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

/// Detail levels by ascending cost.
std::vector<std::string> levels(Registry const& registry) {
    std::vector<ComponentText> found;
    for (Registration const& registration : registry.components()) {
        auto const& offers = registration.info->offers;
        if (std::find(offers.begin(), offers.end(), &propertyInfo<ElectricalState>()) != offers.end()) {
            found.push_back(registration.info->text);
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](ComponentText const& a, ComponentText const& b) { return a.rank < b.rank; });
    std::vector<std::string> names;
    names.reserve(found.size());
    for (ComponentText const& text : found) {
        names.emplace_back(text.level);
    }
    return names;
}

// The current that a level without currents implies for a lamp that is on: its rated current.
constexpr double ratedAmperes = lampWatts / sourceVolts;

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
        state("current_capacity", ratedAmperes); // only used by the level flow
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

using Amperes = std::vector<std::vector<double>>; // by circuit and part

struct Measured {
    double microseconds = 0;
    double wrong = 0;   ///< share of the lamps whose state is wrong
    double amperes = 0; ///< mean error of the current through a lamp
};

Measured measure(std::vector<Wiring> const& circuits, LevelFile const& file, std::string const& level,
                 Amperes const& right, int frames) {
    WorldOptions options;
    options.detail["electricity"] = level;
    auto const world = buildWorld(electricityAlone(), file, PartLibrary{}, {}, options);
    for (int frame = 0; frame < 3; ++frame) {
        world->step();
    }
    Store& store = world->store();
    int lamps = 0;
    Measured found;
    auto const& state = *world->find<ElectricalState>();
    auto const* const quantities = world->find<ElectricalQuantities>();
    for (std::size_t c = 0; c < circuits.size(); ++c) {
        std::vector<bool> const glow = glowing(circuits[c]);
        for (std::size_t p = 0; p < glow.size(); ++p) {
            if (circuits[c].parts[p] == Part::lamp) {
                ObjectId const lamp = store.find(nameOf(c, p));
                auto const* const known = quantities == nullptr ? nullptr : quantities->find(lamp);
                double const amperes = known != nullptr   ? known->current
                                       : state.isOn(lamp) ? ratedAmperes
                                                          : 0;
                ++lamps;
                found.wrong += state.isOn(lamp) != glow[p] ? 1 : 0;
                found.amperes += std::abs(amperes - right[c][p]);
            }
        }
    }
    found.wrong /= std::max(1, lamps);
    found.amperes /= std::max(1, lamps);
    // The cost of changes: in every frame one cable is cut, or the one cut in the last frame is repaired.
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
    found.microseconds = clock.median();
    return found;
}

struct Reference {
    std::string name;
    Amperes amperes;
};

// ngspice on the netlist of the same world, where ngspice is installed.
Reference referenceOf(std::vector<Wiring> const& circuits, LevelFile const& file) {
    auto const world = buildWorld(electricityAlone(), file, PartLibrary{}, {}, {});
    world->step();
    world->step();
    auto const spice = potentialsByNgspice(spiceNetlist(world->store(), "circuits"));
    Reference reference;
    reference.name = spice ? "ngspice on the same netlist"
                           : "Kirchhoff's laws by Gaussian elimination, as ngspice is not installed";
    for (std::size_t c = 0; c < circuits.size(); ++c) {
        std::vector<double> volts = potentials(circuits[c]);
        for (std::size_t p = 0; spice && p < volts.size(); ++p) {
            auto const found = spice->find(nameOf(c, p));
            // Floating objects are not in ngspice's result.
            volts[p] = found == spice->end() ? 0 : found->second;
        }
        reference.amperes.push_back(currents(circuits[c], volts));
    }
    return reference;
}

enum class Question : std::uint8_t { glows, amperes };

Ladder climbCircuits(std::vector<Wiring> const& circuits, std::string scene, Question question,
                     Effort effort) {
    LevelFile const file = levelOf(electricityAlone(), circuits);
    Reference const reference = referenceOf(circuits, file);
    Ladder ladder;
    bool const glows = question == Question::glows;
    ladder.scene = std::move(scene) + (glows ? "" : ", how much current");
    ladder.unit = glows ? "of the lamps" : "A";
    ladder.error = glows
                       ? "share of the lamps that are on though they are dark, or off though they glow; one "
                         "cable changes in every frame"
                       : fmt::format("mean error of the current through a lamp of {:g} A; where a level "
                                     "knows on and off only, on counts as that",
                                     ratedAmperes);
    ladder.reference =
        glows ? "Kirchhoff's laws by Gaussian elimination; a lamp glows from 1 % of its rated power on"
              : reference.name;
    for (std::string const& level : levels(electricityAlone())) {
        Measured const found = measure(circuits, file, level, reference.amperes, effort.brief ? 25 : 481);
        ladder.rungs.push_back(
            {level, found.microseconds, glows ? found.wrong : found.amperes, {}, false, {}});
    }
    ladder.remark =
        glows ? "The simpler levels are not worse at their own task: their result is which objects are "
                "connected, not which lamps glow. These are their errors if they are used for that all the "
                "same. Two-wire is better than flow, which finds the same lamps on and takes longer: no "
                "scene uses flow unless it is requested. It computes what no other level does, the "
                "bottlenecks ([electricity.md](../electricity.md))."
              : "For flow every lamp states that it can carry its rated current, so flow has more data than "
                "two-wire. Nodal is better, as it takes less time and uses Ohm's law; the task of flow is "
                "another one, bottlenecks ([electricity.md](../electricity.md)).";
    return ladder;
}

} // namespace

void addElectricityPlans(std::vector<Plan>& plans) {
    for (Question const question : {Question::glows, Question::amperes}) {
        plans.push_back({"electricity", [question](GameData const&, Effort effort) {
                             int const count = effort.brief ? 12 : 120;
                             return climbCircuits(schoolbook(count),
                                                  fmt::format("{} schoolbook circuits", count), question,
                                                  effort);
                         }});
        plans.push_back({"electricity", [question](GameData const&, Effort effort) {
                             int const count = effort.brief ? 8 : 100;
                             return climbCircuits(jumble(count, 24),
                                                  fmt::format("{} circuits joined at random", count),
                                                  question, effort);
                         }});
    }
}

} // namespace trembler::accuracy
