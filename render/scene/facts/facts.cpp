#include "render/scene/facts/facts.hpp"

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

} // namespace

FactsReader::FactsReader(World const& world)
    : columns_(world.store()), state_(world.find<ElectricalState>()) {}

Facts FactsReader::of(ObjectId id) const {
    Facts facts = gather([&]<class P>() { return columns_.find<P>(id); });
    facts.id = id;
    facts.on = state_ != nullptr && state_->isOn(id);
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
