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

template <class P>
P const* in(Column<P> const* column, ObjectId id) {
    return column == nullptr ? nullptr : column->find(id);
}

bool has(ColumnBase const* column, ObjectId id) {
    return column != nullptr && column->has(id);
}

void guessSubstance(Facts& facts) {
    bool const attracted = facts.strength != nullptr && facts.strength->susceptibility > 0;
    facts.fixed = facts.fixed || facts.liquid; // it stays where it is
    if (facts.look != nullptr && facts.look->pattern != trembler::Pattern::own) {
        facts.substance = materialOf(facts.look->pattern);
    } else if (facts.madeOf != nullptr) {
        facts.substance = facts.madeOf->material;
    } else {
        facts.substance =
            facts.liquid ? Substance::water : substanceWithoutLook(facts.fixed, facts.conductor, attracted);
    }
}

int level(Facts const& facts) {
    if (facts.shape == nullptr) {
        return 3;
    }
    return facts.liquid ? 0 : (facts.fixed ? 1 : 2);
}

} // namespace

FactsReader::FactsReader(World const& world)
    : positions_(world.store().findColumn<Position>()), rotations_(world.store().findColumn<Rotation>()),
      shapes_(world.store().findColumn<Shape>()), fixed_(world.store().findColumn<Fixed>()),
      liquids_(world.store().findColumn<Liquid>()), conductors_(world.store().findColumn<Conductor>()),
      sources_(world.store().findColumn<ElectricalSource>()),
      returns_(world.store().findColumn<ElectricalReturn>()),
      devices_(world.store().findColumn<ElectricalDevice>()),
      poles_(world.store().findColumn<MagneticPoles>()), magnets_(world.store().findColumn<Magnet>()),
      strengths_(world.store().findColumn<MagneticStrength>()),
      coils_(world.store().findColumn<Electromagnet>()), state_(world.find<ElectricalState>()),
      madeOf_(world.store().findColumn<MadeOf>()), looks_(world.store().findColumn<Look>()) {}

Facts FactsReader::of(ObjectId id) const {
    Facts facts;
    facts.id = id;
    facts.position = in(positions_, id);
    facts.rotation = in(rotations_, id);
    facts.shape = in(shapes_, id);
    facts.fixed = has(fixed_, id);
    facts.liquid = has(liquids_, id);
    facts.conductor = has(conductors_, id);
    facts.source = has(sources_, id);
    facts.earth = has(returns_, id);
    facts.device = has(devices_, id);
    facts.on = state_ != nullptr && state_->isOn(id);
    facts.poles = in(poles_, id);
    facts.magnet = in(magnets_, id);
    facts.strength = in(strengths_, id);
    facts.coil = in(coils_, id);
    facts.madeOf = in(madeOf_, id);
    facts.look = in(looks_, id);
    guessSubstance(facts);
    return facts;
}

std::vector<Facts> FactsReader::drawOrder() const {
    std::vector<Facts> all;
    if (positions_ == nullptr) {
        return all;
    }
    for (ObjectId const id : positions_->owners()) {
        Facts const facts = of(id);
        if (facts.visible()) {
            all.push_back(facts);
        }
    }
    std::stable_sort(all.begin(), all.end(),
                     [](Facts const& a, Facts const& b) { return level(a) < level(b); });
    return all;
}

Facts factsOf(Prototype const& prototype) {
    Facts facts;
    facts.position = valueIn<Position>(prototype);
    facts.rotation = valueIn<Rotation>(prototype);
    facts.shape = valueIn<Shape>(prototype);
    facts.fixed = valueIn<Fixed>(prototype) != nullptr;
    facts.liquid = valueIn<Liquid>(prototype) != nullptr;
    facts.conductor = valueIn<Conductor>(prototype) != nullptr;
    facts.source = valueIn<ElectricalSource>(prototype) != nullptr;
    facts.earth = valueIn<ElectricalReturn>(prototype) != nullptr;
    facts.device = valueIn<ElectricalDevice>(prototype) != nullptr;
    facts.poles = valueIn<MagneticPoles>(prototype);
    facts.magnet = valueIn<Magnet>(prototype);
    facts.strength = valueIn<MagneticStrength>(prototype);
    facts.coil = valueIn<Electromagnet>(prototype);
    facts.madeOf = valueIn<MadeOf>(prototype);
    facts.look = valueIn<Look>(prototype);
    guessSubstance(facts);
    return facts;
}

} // namespace trembler::render
