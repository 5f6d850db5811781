// Computes samples from the sounds of a world: one mono stream per sounding object.
#pragma once

#include "audio/effect/properties/sounds.hpp"
#include "audio/synth/masking.hpp"
#include "audio/synth/modal_bank.hpp"
#include "audio/synth/recording.hpp"

#include <map>
#include <optional>

namespace trembler {

/// The listener: above a point of the world, at a distance from its plane.
struct Listener {
    Vec2 at;           ///< m
    double height = 3; ///< m, above zero
    Vec2 velocity;     ///< m/s
};

struct SynthesiserOptions {
    int rate = 48000;    ///< Hz
    int block = 800;     ///< samples: a frame of the world
    bool masking = true; ///< leave out tones that cannot be heard beside the rest
    bool doppler = true;
    /// For impacts and noises louder than `comfortable` (dB at 1 m), the decibels above it are multiplied by
    /// this. 1: no change. A falling girder is 70 dB louder than a rolling die; loudspeakers in a living room
    /// must play both.
    double compression = 0.35;
    double comfortable = 70;
};

/// A stream and its next block.
struct Voice {
    std::uint64_t stream = 0; ///< the same from block to block
    ObjectId object;
    Vec2 at;                        ///< m, in the world
    Vec2 velocity;                  ///< m/s
    std::span<float const> samples; ///< Pa at a distance of 1 m; valid until the next block
    double power = 0;               ///< Pa², mean square of these, about
};

struct SynthesiserCounts {
    std::size_t bodies = 0;
    std::size_t modes = 0;    ///< that sound
    std::size_t rendered = 0; ///< of these; the others are masked
};

/// Its output depends on its inputs and their order alone: equal worlds make equal samples. Used by one
/// thread at a time.
class Synthesiser {
public:
    explicit Synthesiser(SynthesiserOptions options = {}, SampleSource* recordings = nullptr);

    /// Adds the new sounds of a frame; a frame that was added before, as in a paused world, is ignored.
    void hear(Sounds const& sounds, Listener const& listener);
    /// The next block, ascending by stream. Struck bodies ring on even if hear() is not called in between.
    std::span<Voice const> render();
    /// Resets everything, for another world.
    void clear();

    [[nodiscard]] SynthesiserOptions const& options() const { return options_; }
    /// The counts of the last block.
    [[nodiscard]] SynthesiserCounts const& counts() const { return counts_; }

private:
    struct Click {
        int sample = 0;
        int length = 0;
        double pressure = 0; // Pa
    };
    struct BodyVoice {
        explicit BodyVoice(double rate) : bank(rate) {}
        ModalBank bank;
        std::vector<Sounds::Ring> rings; // as last heard
        std::vector<Click> clicks;
        Vec2 at;
        Vec2 velocity;
        double pitch = 1;
        double attenuation = 1; // factor on power, on the way to the listener
        bool gone = false;
        std::vector<std::uint8_t> audible;
        bool anyAudible = false;
        double power = 0;   // Pa², of the next block
        int unheard = 1000; // blocks in a row
    };
    struct RecordingVoice {
        std::optional<SamplePlayer> player;
        ObjectId object;
        Vec2 at;
        Vec2 velocity;
        double pressure = 0;
        double pitch = 1;
        bool gone = false;
        bool listed = false; // whether it is in the sounds of the last frame
    };

    void hearBodies(Sounds const& sounds);
    void hearImpacts(Sounds const& sounds);
    void hearRecordings(Sounds const& sounds);
    void findAudible();
    void renderBody(ObjectId object, BodyVoice& voice, std::span<float> out);
    [[nodiscard]] double pitchOf(Vec2 at, Vec2 velocity) const;
    [[nodiscard]] double attenuationOf(Vec2 at) const;
    /// The factor on pressures that turns a mean square of `meanSquare` (Pa²) into the rendered one.
    [[nodiscard]] double compressed(double meanSquare) const;
    std::span<float> newStream(std::uint64_t stream, ObjectId object, Vec2 at, Vec2 velocity, double power);

    SynthesiserOptions options_;
    SampleSource* recordings_;
    Listener listener_;
    std::uint64_t heardFrame_ = 0;
    std::uint64_t blocks_ = 0;
    std::map<ObjectId, BodyVoice> bodies_;
    std::map<std::uint64_t, RecordingVoice> recordingVoices_; // by serial
    Masker masker_;
    ModalScratch scratch_;
    std::vector<Tone> tones_;           // a member to reuse its memory
    std::vector<std::uint8_t> audible_; // likewise
    std::vector<float> samples_;        // of all voices
    std::vector<float> unheard_;        // stays silent: masked modes are not rendered
    std::vector<Voice> voices_;
    SynthesiserCounts counts_;
};

} // namespace trembler
