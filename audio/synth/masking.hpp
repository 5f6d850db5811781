// Finds tones that the ear cannot hear beside others, so that they need not be rendered (Raghuvanshi and Lin,
// Interactive sound synthesis for large scale environments, I3D 2006).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace trembler {

/// The critical-band rate of a frequency in Hz, in Bark (Zwicker and Terhardt 1980); 0 to about 24.6.
[[nodiscard]] double barkOf(double frequency);
/// The faintest audible mean square pressure of a tone, in Pa² (Terhardt 1979).
[[nodiscard]] double hearingThreshold(double frequency);
/// Both values from a table in steps of 4 Hz, as thousands of modes need them: exact to 0.01 Bark and, above
/// 60 Hz, 0.5 dB.
struct Hearing {
    double bark = 0;
    double threshold = 0; ///< Pa²
};
[[nodiscard]] Hearing hearingAt(double frequency);
/// The share of the power of a tone at `masker` (Bark) below which another tone at `bark` is inaudible;
/// `level` of the masker in dB. The spreading function and the masking index for tones of psychoacoustic
/// model 1 of ISO/IEC 11172-3.
[[nodiscard]] double maskingShare(double masker, double level, double bark);

/// A tone at the listener's ear.
struct Tone {
    double bark = 0;
    double power = 0;     ///< Pa², mean square
    double threshold = 0; ///< Pa², hearingThreshold of its frequency
};

/// Finds the audible tones. Reuses its memory between calls.
class Masker {
public:
    /// Sets audible[i] for every tone. The loudest audible tones mask the inaudible ones: in every critical
    /// band, all inaudible tones together have no more power than is masked there, or than the hearing
    /// threshold. O(n) for many tones.
    void findAudible(std::span<Tone const> tones, std::vector<std::uint8_t>& audible);

    static constexpr int binsPerBark = 4;
    static constexpr int bins = 25 * binsPerBark + 1;
    /// The greatest number of masking tones; fainter ones mask little.
    static constexpr std::size_t mostMaskers = 96;

private:
    void mask(Tone const& tone);

    std::array<double, bins> masked_{}; // Pa², inaudible power
    std::array<double, bins> dropped_{};
    std::vector<std::uint32_t> order_;
};

} // namespace trembler
