// Which of many tones the ear cannot hear beside the others, so that they need not be rendered (Raghuvanshi
// and Lin, Interactive sound synthesis for large scale environments, I3D 2006).
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
/// Both, from a table in steps of 4 Hz, for thousands of modes at a time: within 0.01 Bark and, above 60 Hz,
/// 0.5 dB.
struct Hearing {
    double bark = 0;
    double threshold = 0; ///< Pa²
};
[[nodiscard]] Hearing hearingAt(double frequency);
/// The share of a tone's power at `masker` (Bark) below which another at `bark` goes unheard; `level` of the
/// masker in dB. The spreading function and the masking index for tones of psychoacoustic model 1 of ISO/IEC
/// 11172-3.
[[nodiscard]] double maskingShare(double masker, double level, double bark);

/// A tone at the listener's ear.
struct Tone {
    double bark = 0;
    double power = 0;     ///< Pa², mean square
    double threshold = 0; ///< Pa², hearingThreshold of its frequency
};

/// Finds the audible ones. Keeps memory between calls.
class Masker {
public:
    /// Sets audible[i] for every tone. The tones left out are masked by the loudest of those kept: in every
    /// critical band, all tones left out together have no more power than these mask there, or than the
    /// hearing threshold. O(n) for many tones.
    void findAudible(std::span<Tone const> tones, std::vector<std::uint8_t>& audible);

    static constexpr int binsPerBark = 4;
    static constexpr int bins = 25 * binsPerBark + 1;
    /// Tones beyond these are too faint beside them to mask much.
    static constexpr std::size_t mostMaskers = 96;

private:
    void mask(Tone const& tone);

    std::array<double, bins> masked_{}; // Pa² that go unheard
    std::array<double, bins> dropped_{};
    std::vector<std::uint32_t> order_;
};

} // namespace trembler
