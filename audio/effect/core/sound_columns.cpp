#include "audio/effect/core/sound_columns.hpp"

#include "audio/effect/core/contact_pulse.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"

#include <utility>

namespace trembler {

BodyFacts SoundColumns::factsOf(ObjectId id) const {
    BodyFacts facts;
    Shape const* const form = shape.find(id);
    MadeOf const* const of = madeOf.find(id);
    facts.acoustics = acoustics.find(id);
    bool const isLiquid = liquid.has(id);
    Mass const* const heavy = mass.find(id); // every object with a shape has a mass, also if fixed
    if (form == nullptr || heavy == nullptr || (of == nullptr && facts.acoustics == nullptr && !isLiquid) ||
        faultIn(*form)) {
        return facts;
    }
    facts.shape = form;
    facts.fixed = fixed.has(id);
    if (isLiquid) {
        facts.material = Material::water; // for any liquid: the sound is that of bubbles
    } else if (of != nullptr) {
        facts.material = of->material;
    }
    facts.mass = heavy->value;
    return facts;
}

double SoundColumns::contactTimeOf(ObjectId a, ObjectId b, double impulse) const {
    if (b < a) {
        std::swap(a, b); // both sounds of an impact have the same time, to the bit
    }
    auto const materialAt = [this](ObjectId id) {
        MadeOf const* const of = madeOf.find(id);
        return of == nullptr ? Material::plastic : of->material;
    };
    auto const roundnessAt = [this](ObjectId id) {
        Shape const* const form = shape.find(id);
        return form == nullptr ? 0 : roundnessOf(*form);
    };
    auto const inverseMassAt = [this](ObjectId id) {
        Mass const* const heavy = mass.find(id);
        return heavy == nullptr || fixed.has(id) ? 0 : 1 / heavy->value;
    };
    double const inverse = inverseMassAt(a) + inverseMassAt(b); // 1/kg; of two fixed objects 0
    return contactTime(materialAt(a), materialAt(b), roundnessAt(a), roundnessAt(b), 1 / inverse,
                       impulse * inverse);
}

std::array<std::uint64_t, 7> SoundColumns::voiceVersions() const {
    return {shape.version(), madeOf.version(), acoustics.version(), sample.version(),
            mass.version(),  fixed.version(),  liquid.version()};
}

SoundingBodies::Facts::Facts(BodyFacts const& from)
    : shape(*from.shape), material(from.material), mass(from.mass), fixed(from.fixed) {
    if (from.acoustics != nullptr) {
        acoustics = *from.acoustics;
    }
}

bool SoundingBodies::Facts::hold(BodyFacts const& now) const {
    bool const sameAcoustics =
        now.acoustics == nullptr ? !acoustics : acoustics && *acoustics == *now.acoustics;
    return sameAcoustics && material == now.material && mass == now.mass && fixed == now.fixed &&
           shape == *now.shape;
}

void SoundingBodies::follow(SoundColumns const& columns) {
    constexpr std::size_t many = 2000;
    std::array<std::uint64_t, 7> const versions = columns.voiceVersions();
    if (epoch_ > 0 && versions == seen_) {
        return;
    }
    seen_ = versions;
    ++epoch_;
    std::erase_if(known_, [&](auto const& entry) { return !columns.shape.has(entry.first); });
    if (epoch_ == 1 && columns.madeOf.size() <= many) {
        for (ObjectId const id : columns.madeOf.owners()) {
            static_cast<void>(find(columns, id));
        }
    }
}

SoundingBody const* SoundingBodies::find(SoundColumns const& columns, ObjectId id) {
    Known& known = known_[id];
    if (known.epoch != epoch_) {
        BodyFacts const facts = columns.factsOf(id);
        bool const sounds = facts.shape != nullptr;
        if (sounds && !(known.sounds && known.facts.hold(facts))) {
            known.facts = Facts(facts);
            known.model = SoundingBody(facts, modes_);
        }
        known.sounds = sounds;
        known.epoch = epoch_;
    }
    return known.sounds ? &known.model : nullptr;
}

} // namespace trembler
