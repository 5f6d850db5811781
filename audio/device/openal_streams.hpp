// The sources of OpenAL that play streams, each with a queue of blocks.
#pragma once

#include "audio/device/openal.hpp"

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace trembler {

/// The place of a source: in the world, or relative to the listener. In m.
struct SourcePlace {
    double x = 0;
    double y = 0;
    double z = 0;
    bool relative = false;
};

/// For every function except has() and slips() the context of the sources must be current.
class OpenAlStreams {
public:
    /// Blocks of `block` samples, `rate` samples in a second. `fullScale` is the pressure, in Pa, that is
    /// played at the greatest amplitude. With two channels a stream has no place: its samples, left and right
    /// in turn, are played as they are.
    OpenAlStreams(int block, int rate, double fullScale, int channels = 1);

    /// Sets the effect slot of sources created from now on; 0 for none.
    void sendTo(ALuint slot) { slot_ = slot; }
    /// Sets the silence before a stream begins, so that its queue does not run empty: so many buffers of
    /// `samples` each.
    void setCushion(int buffers, int samples);

    /// Creates in advance all OpenAL objects that `streams` streams beginning at the same time need, so that
    /// the frame in which they begin takes no longer. To be called after sendTo() and setCushion().
    void prepare(int streams);

    /// Takes back the buffers that have been played. To be called once for every block.
    void reclaim();
    /// The number of buffers that wait in the longest queue.
    [[nodiscard]] int longestQueue() const;
    /// Queues the next block of a stream. Does nothing if OpenAL has no source for it.
    void queue(std::uint64_t stream, SourcePlace const& place, std::span<float const> samples);
    /// To be called after the last queue() of a block. Streams that were not queued in it have ended: they
    /// play the rest of their queue, and then release their source.
    void retire();
    [[nodiscard]] bool has(std::uint64_t stream) const { return sources_.contains(stream); }
    /// How often the queue of a stream has run empty.
    [[nodiscard]] std::uint64_t slips() const { return slips_; }

    /// Plays a whole sound without a place, beside the streams; left out if eight play already.
    void once(std::span<float const> samples, double gain);

    /// Stops all streams at once.
    void stop();
    /// Stops all sound and deletes all sources and buffers. To be called before the context is destroyed.
    void destroy();

private:
    struct Source {
        ALuint id = 0;
        bool used = false; // in this block
    };

    /// A sound that is played once; reused when it has ended.
    struct Once {
        ALuint source = 0;
        ALuint buffer = 0;
    };

    bool addIdleSource();
    void addIdleBuffer();
    void fill(ALuint buffer, std::span<float const> samples);
    [[nodiscard]] Source* sourceFor(std::uint64_t stream);
    [[nodiscard]] ALuint freeBuffer();
    void reclaim(Source& source);
    void queue(Source& source, std::span<float const> samples);

    int rate_;         // Hz
    double fullScale_; // Pa
    int channels_;
    ALuint slot_ = 0;
    int cushion_ = 2;                         // buffers
    std::map<std::uint64_t, Source> sources_; // by stream
    std::vector<ALuint> idleSources_;
    std::vector<ALuint> allSources_;
    std::vector<ALuint> idleBuffers_;
    std::vector<ALuint> allBuffers_;
    std::vector<Once> once_;
    std::vector<float> scaled_;  // a member to reuse its memory
    std::vector<float> silence_; // of one buffer of the cushion
    std::uint64_t slips_ = 0;
};

} // namespace trembler
