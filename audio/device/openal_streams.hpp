// The sources of OpenAL that play streams, each with a queue of blocks.
#pragma once

#include "audio/device/openal.hpp"

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace trembler {

/// Where a source stands: in the world, or relative to the listener. In m.
struct SourcePlace {
    double x = 0;
    double y = 0;
    double z = 0;
    bool relative = false;
};

/// Every function but has() and slips() needs the context to be current in which the sources are.
class OpenAlStreams {
public:
    /// Blocks of `block` samples, `rate` samples in a second. `fullScale` is the pressure, in Pa, that is
    /// played as loud as can be.
    OpenAlStreams(int block, int rate, double fullScale);

    /// The effect slot that sources send to which are made from now on; 0 for none.
    void sendTo(ALuint slot) { slot_ = slot; }
    /// Blocks of silence before a stream begins, so that its queue does not run dry at once.
    void setCushion(int blocks) { cushion_ = blocks; }

    /// Whether so much is waiting to be played already that the next block is better left out.
    [[nodiscard]] bool ahead();
    /// Queues the next block of a stream. Does nothing if OpenAL gives no source for it.
    void queue(std::uint64_t stream, SourcePlace const& place, std::span<float const> samples);
    /// After the last queue() of a block. Streams that were not queued in it have ended: they play the rest
    /// of their queue, and then give their source back.
    void retire();
    [[nodiscard]] bool has(std::uint64_t stream) const { return sources_.contains(stream); }
    /// How often a stream has run dry.
    [[nodiscard]] std::uint64_t slips() const { return slips_; }

    /// Silence, at once.
    void stop();
    /// Silence, and all sources and buffers go; before the context goes.
    void destroy();

private:
    struct Source {
        ALuint id = 0;
        bool used = false; // in this block
    };

    [[nodiscard]] Source* sourceFor(std::uint64_t stream);
    [[nodiscard]] ALuint freeBuffer();
    void reclaim(Source& source);
    void queue(Source& source, std::span<float const> samples);

    int rate_;         // Hz
    double fullScale_; // Pa
    ALuint slot_ = 0;
    int cushion_ = 2;
    std::map<std::uint64_t, Source> sources_; // by stream
    std::vector<ALuint> idleSources_;
    std::vector<ALuint> allSources_;
    std::vector<ALuint> idleBuffers_;
    std::vector<ALuint> allBuffers_;
    std::vector<float> scaled_;
    std::uint64_t slips_ = 0;
};

} // namespace trembler
