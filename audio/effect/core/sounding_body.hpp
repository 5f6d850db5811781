// The modes of a body, and how an impact excites them (van den Doel and Pai, The sounds of physical shapes,
// Presence 7, 1998).
#pragma once

#include "audio/effect/properties/acoustic_material.hpp"
#include "audio/effect/properties/acoustics.hpp"
#include "physics/dynamics/properties/shape.hpp"

#include <vector>

namespace trembler {

inline constexpr int mostModes = 32;

/// The properties that determine an object's sound.
struct BodyFacts {
    Shape const* shape = nullptr; ///< valid, see faultIn()
    Material material = Material::plastic;
    Acoustics const* acoustics = nullptr; ///< or none
    double mass = 1;                      ///< kg
    bool fixed = false;
};

/// One way in which a body vibrates.
struct Mode {
    double frequency = 0;  ///< Hz, within the audible range
    double decay = 0;      ///< 1/s, of the amplitude
    double radiation = 0;  ///< Pa at a distance of 1 m, in free air, for a modal velocity of 1 m/s
    double audibility = 1; ///< the ear's factor on its mean square pressure (A-weighting)
    double weight = 1;     ///< of its deflection
    int m = 0;             ///< nodal lines or number of the mode in its form
    int n = 0;
};

/// The acoustic model of an object. Immutable once made; about a kilobyte.
class SoundingBody {
public:
    SoundingBody() = default;
    /// The `count` lowest audible modes, 1 to mostModes. A body that is too small or too soft for audible
    /// modes has none: it only clicks.
    SoundingBody(BodyFacts const& facts, int count);

    /// Ascending by frequency; a model with fewer modes has the first of these.
    [[nodiscard]] std::vector<Mode> const& modes() const { return modes_; }
    [[nodiscard]] double mass() const { return mass_; }
    /// The modal velocity, in m/s, that an impulse of 1 N s gives a mode: shape over mass. `point` (m) and
    /// the unit vector `normal` are in the object's frame. Its sign counts.
    [[nodiscard]] double mobility(Mode const& mode, Vec2 point, Vec2 normal) const;
    /// The source of the sound of an impact at `point` along `normal`, all in the object's frame: the middle
    /// of the body; of a long body the point of its axis nearest to the impact; of a built-in body a point
    /// directly outside its surface, as its inside is silent.
    [[nodiscard]] Vec2 sourceOf(Vec2 point, Vec2 normal) const;
    /// The volume of air, in m³, that moves with the body: its own volume and half as much added. 0 for a
    /// built-in body.
    [[nodiscard]] double movedAir() const { return movedAir_; }

private:
    enum class Form { bar, plate, ball, bell, drops };

    void place(ShapePiece const& piece);
    void keepNear();
    void addBarModes(AcousticMaterial const& material);
    void addPlateModes(AcousticMaterial const& material);
    void addBallModes(AcousticMaterial const& material);
    void addBellModes();
    void addDrops();
    void tune(Acoustics const& acoustics);
    void damp(AcousticMaterial const& material, BodyFacts const& facts);
    void keepAudible(int count);

    Form form_ = Form::plate;
    Vec2 centre_;          // m, of the frame around the main piece, in the object's frame
    double angle_ = 0;     // rad, of the frame's long side
    double length_ = 1;    // m, long side
    double height_ = 1;    // m, short side
    Vec2 answering_{1, 1}; // the shares of length and height that vibrate with an impact
    double mass_ = 1;      // kg
    double surface_ = 1;   // m², radiating
    double movedAir_ = 0;  // m³
    bool builtIn_ = false;
    std::vector<Mode> modes_;
};

} // namespace trembler
