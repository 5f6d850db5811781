#include "render/scene/facts/facts.hpp"

#include "physics/electricity/properties/graph.hpp"

#include <algorithm>

namespace trembler::render {
namespace {

template <class P>
P const* valueIn(Prototype const& prototype) {
    for (auto const& value : prototype.values) {
        if (value != nullptr && value->info().type == propertyInfo<P>().type) {
            return &static_cast<ValueOf<P> const&>(*value).value;
        }
    }
    return nullptr;
}

void guessSubstance(Facts& facts) {
    bool const attracted = facts.strength != nullptr && facts.strength->susceptibility > 0;
    facts.fixed = facts.fixed || facts.liquid; // it stays where it is
    if (facts.look != nullptr && facts.look->pattern != LookPattern::own) {
        facts.substance = materialOf(facts.look->pattern);
    } else if (facts.madeOf != nullptr) {
        facts.substance = facts.madeOf->material;
    } else {
        facts.substance =
            facts.liquid ? Substance::water : substanceWithoutLook(facts.fixed, facts.conductor, attracted);
    }
}

// In ascending order from bottom to top.
std::pair<int, int> level(Facts const& facts) {
    int const layer = facts.drawing != nullptr ? facts.drawing->layer : 0;
    if (facts.shape == nullptr) {
        return {layer, 3};
    }
    return {layer, facts.liquid ? 0 : (facts.fixed ? 1 : 2)};
}

/// `find.operator()<P>()` returns the object's property P, or nullptr.
template <class Find>
Facts gather(Find const& find) {
    Facts facts;
    facts.position = find.template operator()<Position>();
    facts.rotation = find.template operator()<Rotation>();
    facts.shape = find.template operator()<Shape>();
    facts.fixed = find.template operator()<Fixed>() != nullptr;
    facts.liquid = find.template operator()<Liquid>() != nullptr;
    facts.conductor = find.template operator()<Conductor>() != nullptr;
    facts.source = find.template operator()<ElectricalSource>() != nullptr;
    facts.earth = find.template operator()<ElectricalReturn>() != nullptr;
    facts.device = find.template operator()<ElectricalDevice>() != nullptr;
    facts.poles = find.template operator()<MagneticPoles>();
    facts.magnet = find.template operator()<Magnet>();
    facts.strength = find.template operator()<MagneticStrength>();
    facts.coil = find.template operator()<Electromagnet>();
    facts.madeOf = find.template operator()<MadeOf>();
    facts.look = find.template operator()<Look>();
    facts.drawing = find.template operator()<Drawing>();
    if (DrawnAs const* const stated = find.template operator()<DrawnAs>()) {
        facts.form = stated->form;
    }
    guessSubstance(facts);
    return facts;
}

/// For objects welded to bodies that turn freely about the world, the place about which the bodies turn.
/// Empty without electricity, as only wires need it.
std::vector<std::pair<ObjectId, Vec2 const*>> axlesOf(Store const& store) {
    std::vector<std::pair<ObjectId, Vec2 const*>> turning;
    std::vector<std::pair<ObjectId, Vec2 const*>> axles;
    auto const* const joints = store.findColumn<Joint>();
    auto const* const graph = store.findColumn<ElectricityGraph>();
    if (joints == nullptr || graph == nullptr || graph->empty()) {
        return axles;
    }
    for (Joint const& joint : joints->values()) {
        if (joint.form == JointForm::hinge && !joint.limited && !joint.b.valid()) {
            turning.emplace_back(joint.a, &joint.at);
        }
    }
    std::stable_sort(turning.begin(), turning.end(),
                     [](auto const& one, auto const& other) { return one.first < other.first; });
    auto const add = [&](ObjectId object, ObjectId body) {
        auto const hinge = std::lower_bound(turning.begin(), turning.end(), body,
                                            [](auto const& entry, ObjectId id) { return entry.first < id; });
        if (object.valid() && hinge != turning.end() && hinge->first == body) {
            axles.emplace_back(object, hinge->second);
        }
    };
    for (Joint const& joint : joints->values()) {
        if (joint.form == JointForm::weld && !turning.empty()) {
            add(joint.a, joint.b);
            add(joint.b, joint.a);
        }
    }
    std::stable_sort(axles.begin(), axles.end(),
                     [](auto const& one, auto const& other) { return one.first < other.first; });
    return axles;
}

} // namespace

FactsReader::FactsReader(World const& world)
    : columns_(world.store()), state_(world.find<ElectricalState>()), axles_(axlesOf(world.store())) {}

Facts FactsReader::of(ObjectId id) const {
    Facts facts = gather([&]<class P>() { return columns_.find<P>(id); });
    facts.id = id;
    facts.on = state_ != nullptr && state_->isOn(id);
    auto const axle =
        std::lower_bound(axles_.begin(), axles_.end(), id,
                         [](auto const& entry, ObjectId object) { return entry.first < object; });
    facts.axle = axle != axles_.end() && axle->first == id ? axle->second : nullptr;
    return facts;
}

std::vector<Facts> FactsReader::drawOrder() const {
    std::vector<Facts> all;
    auto const* const positions = std::get<Column<Position> const*>(columns_.all);
    if (positions == nullptr) {
        return all;
    }
    for (ObjectId const id : positions->owners()) {
        Facts const facts = of(id);
        if (facts.visible()) {
            all.push_back(facts);
        }
    }
    putInDrawOrder(all);
    return all;
}

void putInDrawOrder(std::vector<Facts>& all) {
    std::stable_sort(all.begin(), all.end(),
                     [](Facts const& a, Facts const& b) { return level(a) < level(b); });
}

Facts factsOf(PropertySet const& properties) {
    return gather([&]<class P>() { return properties.find<P>(); });
}

Facts factsOf(Prototype const& prototype) {
    return gather([&]<class P>() { return valueIn<P>(prototype); });
}

} // namespace trembler::render
