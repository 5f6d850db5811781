// The work of the Sound resolver, whatever its number of modes.
#pragma once

#include "audio/effect/calls.hpp"
#include "audio/effect/sounding_body.hpp"
#include "audio/effect/sounds.hpp"
#include "physics/buoyancy/liquid.hpp"
#include "physics/dynamics/body.hpp"
#include "runtime/placement.hpp"
#include "runtime/property/column.hpp"

#include <array>
#include <map>

namespace trembler {

/// The columns that the resolver reads.
struct SoundColumns {
    Column<Shape> const& shape;
    Column<Look> const& look;
    Column<Acoustics> const& acoustics;
    Column<Sample> const& sample;
    Column<Mass> const& mass;
    Column<Density> const& density;
    Column<Fixed> const& fixed;
    Column<Liquid> const& liquid;
    Column<Position> const& position;
    Column<Rotation> const& rotation;
    Column<Velocity> const& velocity;

    /// What is known of an object that can sound; no shape in it if it cannot.
    [[nodiscard]] BodyFacts factsOf(ObjectId id) const;
    /// Changes when any object may have got another voice.
    [[nodiscard]] std::array<std::uint64_t, 8> voiceVersions() const;
};

/// A call and what made it.
template <class C>
struct Told {
    C call;
    EventId cause;
};
/// What has been asked of sound in a frame, in the order in which it is drained.
struct SoundCalls {
    std::vector<Told<Strike>> strikes;
    std::vector<Told<Rub>> rubs;
    std::vector<Told<PlaySample>> plays;
    std::vector<Told<HoldSample>> holds;

    [[nodiscard]] bool empty() const {
        return strikes.empty() && rubs.empty() && plays.empty() && holds.empty();
    }
    void clear();
};

/// Keeps the acoustic models of what has sounded, and moves Sounds on by a frame. Each mode's energy dies
/// away by itself and is added to by blows and scrapes; phases are the loudspeaker's business.
class SoundWork {
public:
    explicit SoundWork(int modes) : modes_(modes) {}

    /// `duration` in s. Works from any `sounds`, also from those that another number of modes has left.
    void advance(SoundColumns const& columns, SoundCalls const& calls, double duration, Sounds& sounds);
    /// Whether there will be something to do in the next frame though nobody calls: something dies away.
    [[nodiscard]] static bool goesOn(Sounds const& sounds);

private:
    /// The model of an object, or nullptr if it cannot sound.
    [[nodiscard]] SoundingBody const* modelOf(SoundColumns const& columns, ObjectId id);
    [[nodiscard]] Sounds::Body& bodyOf(Sounds& sounds, SoundingBody const& model, ObjectId id);
    void fit(SoundColumns const& columns, Sounds& sounds);
    void strike(SoundColumns const& columns, Told<Strike> const& told, double duration, Sounds& sounds);
    void rub(SoundColumns const& columns, Told<Rub> const& told, double duration, Sounds& sounds);
    void dieAway(double duration, Sounds& sounds);
    static void place(SoundColumns const& columns, Sounds& sounds);

    int modes_;
    std::array<std::uint64_t, 8> seen_{};
    std::map<ObjectId, SoundingBody> models_;
    /// Per body of `sounds`: what of this frame's excitation is not in its rings yet.
    struct Fresh {
        double energy = 0;               ///< Pa² s, A-weighted, that was heard in this frame
        double moment = 0;               ///< the same times frequency
        std::vector<double> meanSquares; ///< Pa², left at the frame's end, by mode
    };
    std::map<ObjectId, Fresh> fresh_;
};

} // namespace trembler
