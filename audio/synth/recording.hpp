// Recorded samples for the loudspeaker.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace trembler {

/// A recording in memory, mono.
struct SampleData {
    double rate = 48000;        ///< Hz
    std::vector<float> samples; ///< between -1 and 1
    double rootMeanSquare = 0;  ///< of all samples; see finish()

    /// Computes the root mean square.
    void finish();
};

/// A source of recordings. A recording that is not available is nullptr, and silent.
class SampleSource {
public:
    virtual ~SampleSource() = default;
    [[nodiscard]] virtual std::shared_ptr<SampleData const> find(std::string const& file) = 0;
};

/// Plays a recording at any pitch.
class SamplePlayer {
public:
    SamplePlayer(std::shared_ptr<SampleData const> data, bool looping)
        : data_(std::move(data)), looping_(looping) {}

    /// Adds the next block to `out`, which runs at `rate` Hz, with a root mean square of `pressure` (Pa) over
    /// the recording as a whole. `pitch` above 1 is faster and higher. Interpolates by Catmull and Rom's
    /// cubic. If `fade` is true, it fades out within the block.
    void render(std::span<float> out, double rate, double pressure, double pitch, bool fade);
    [[nodiscard]] bool ended() const { return ended_; }

private:
    [[nodiscard]] float at(std::ptrdiff_t index) const;

    std::shared_ptr<SampleData const> data_;
    bool looping_;
    bool ended_ = false;
    double position_ = 0; // in samples of the recording
};

} // namespace trembler
