// The columns that the Sound resolver reads, and the acoustic models that follow from them.
#pragma once

#include "audio/effect/core/sounding_body.hpp"
#include "physics/buoyancy/properties/liquid.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "runtime/placement.hpp"
#include "runtime/property/column.hpp"

#include <array>
#include <map>
#include <optional>

namespace trembler {

/// The columns that the resolver reads.
struct SoundColumns {
    Column<Shape> const& shape;
    Column<MadeOf> const& madeOf;
    Column<Acoustics> const& acoustics;
    Column<Sample> const& sample;
    Column<Mass> const& mass;
    Column<Fixed> const& fixed;
    Column<Liquid> const& liquid;
    Column<Position> const& position;
    Column<Rotation> const& rotation;
    Column<Velocity> const& velocity;

    /// The properties of an object that can sound; without a shape if it cannot sound.
    [[nodiscard]] BodyFacts factsOf(ObjectId id) const;
    /// How long these two stay in touch in an impact of that impulse (N s), in s: contactTime() for their
    /// materials, masses and roundness. An object without a material counts as one of plastic, one without a
    /// shape as flat, one without a mass as fixed.
    [[nodiscard]] double contactTimeOf(ObjectId a, ObjectId b, double impulse) const;
    /// Changes when the acoustic model of any object may have changed.
    [[nodiscard]] std::array<std::uint64_t, 7> voiceVersions() const;
};

/// The acoustic models of objects, made on first use and kept while they are valid.
class SoundingBodies {
public:
    explicit SoundingBodies(int modes) : modes_(modes) {}

    /// To be called once per frame, before find(). The first call makes the models of all objects of the
    /// world, unless there are very many, so that many simultaneous impacts cause no delay.
    void follow(SoundColumns const& columns);
    /// The model of an object, or nullptr if it cannot sound. Valid until the next follow().
    [[nodiscard]] SoundingBody const* find(SoundColumns const& columns, ObjectId id);

private:
    /// The properties that a model was made from.
    struct Facts {
        Shape shape;
        Material material = Material::plastic;
        std::optional<Acoustics> acoustics;
        double mass = 0;
        bool fixed = false;

        Facts() = default;
        explicit Facts(BodyFacts const& facts);
        [[nodiscard]] bool hold(BodyFacts const& facts) const;
    };
    struct Known {
        std::uint64_t epoch = 0; // in which it was last found valid
        bool sounds = false;
        Facts facts;
        SoundingBody model;
    };

    int modes_;
    std::array<std::uint64_t, 7> seen_{};
    std::uint64_t epoch_ = 0; // counts changes of the properties that models depend on
    std::map<ObjectId, Known> known_;
};

} // namespace trembler
