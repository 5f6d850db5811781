// The work of the Sound resolver, for any number of modes.
#pragma once

#include "audio/effect/calls.hpp"
#include "audio/effect/core/sound_columns.hpp"
#include "audio/effect/properties/sounds.hpp"

namespace trembler {

/// A call and the event that led to it.
template <class C>
struct Received {
    C call;
    EventId cause;
};
/// The calls of a frame, in the order in which they are drained.
struct SoundCalls {
    std::vector<Received<Strike>> strikes;
    std::vector<Received<Rub>> rubs;
    std::vector<Received<PlaySample>> plays;
    std::vector<Received<HoldSample>> holds;

    [[nodiscard]] bool empty() const {
        return strikes.empty() && rubs.empty() && plays.empty() && holds.empty();
    }
    void clear();
};

/// Advances Sounds by a frame. Each mode's energy decays, and impacts and scrapes add to it. Phases are left
/// to the loudspeaker.
class SoundWork {
public:
    explicit SoundWork(int modes) : models_(modes) {}

    /// To be called in every frame, also in silence.
    void follow(SoundColumns const& columns) { models_.follow(columns); }
    /// `duration` in s. Accepts any `sounds`, also results with another number of modes.
    void advance(SoundColumns const& columns, SoundCalls const& calls, double duration, Sounds& sounds);
    /// Whether the next frame has work without any call, as a sound decays.
    [[nodiscard]] static bool goesOn(Sounds const& sounds);

private:
    /// An object that is excited in this frame, with the part of the excitation that is not in the body's
    /// rings yet.
    struct Excited {
        ObjectId object;
        SoundingBody const* model = nullptr;
        Sounds::Body* body = nullptr;
        double energy = 0;     ///< Pa² s, A-weighted, heard in this frame
        double moment = 0;     ///< the same times frequency
        std::size_t first = 0; ///< in left_, one per mode
    };

    void fit(SoundColumns const& columns, Sounds& sounds);
    void findExcited(SoundColumns const& columns, SoundCalls const& calls, Sounds& sounds);
    [[nodiscard]] Excited* excited(ObjectId object);
    void strike(SoundColumns const& columns, Received<Strike> const& received, double duration,
                Sounds& sounds);
    void rub(SoundColumns const& columns, Received<Rub> const& received, double duration, Sounds& sounds);
    void dieAway(double duration, Sounds& sounds);
    static void place(SoundColumns const& columns, Sounds& sounds);

    SoundingBodies models_;
    std::vector<Excited> excited_; // ascending
    std::vector<double> left_;     // Pa², of this frame's excitations at the frame's end
};

} // namespace trembler
