// The modes of one body as damped oscillators that generate samples.
#pragma once

#include "audio/effect/properties/sounds.hpp"
#include "audio/synth/lanes.hpp"

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

namespace trembler {

/// Memory for the computation of a block, used by one bank after another: a few tens of kilobytes that remain
/// in the nearest cache. Nothing in it lasts beyond a call of render().
struct ModalScratch {
    /// The audible modes, in lanes.
    struct Group {
        Lanes re;
        Lanes im;
        Lanes stepRe;
        Lanes stepIm;
        Lanes drive;
    };
    std::vector<Group> groups;
    std::vector<std::uint32_t> packed; // which modes are in the groups
    std::vector<Lanes> sums;
    std::vector<float> noise;
};

/// Each mode is a complex number that rotates and decreases with every sample; its imaginary part is the
/// sound. An impact adds to its real part, so that the pressure begins at zero. Used by one thread at a time.
class ModalBank {
public:
    explicit ModalBank(double rate) : rate_(rate) {}

    /// Sets the modes: their frequencies times `pitch`, their decays plus `damping` (1/s). A mode keeps its
    /// phase and its strength; removed modes become silent. Modes above half the sampling rate stay silent.
    void tune(std::span<Sounds::Ring const> rings, double pitch, double damping);
    /// Adds amplitudes (Pa) to the modes at a sample of the next block. Impacts add up.
    void strike(std::span<double const> amplitudes, double scale, int sample);
    /// Drives each mode with a white noise (Pa/√s) through the next block.
    void scrape(std::span<double const> amplitudes, double scale);

    [[nodiscard]] std::size_t size() const { return modes_.size(); }
    /// The greatest strength of a mode in the next block, as a mean square in Pa².
    [[nodiscard]] double power(std::size_t mode) const;
    [[nodiscard]] double bark(std::size_t mode) const { return modes_[mode].bark; }
    [[nodiscard]] double threshold(std::size_t mode) const { return modes_[mode].threshold; }

    /// Adds the next block to `out`. Modes that are not `audible` continue silently and can become audible
    /// later, in phase. `seed` determines the noise. Returns the number of modes rendered.
    std::size_t render(std::span<float> out, std::span<std::uint8_t const> audible, std::uint64_t seed,
                       ModalScratch& scratch);

private:
    struct Oscillator {
        double frequency = 0; // Hz, with pitch
        double decay = 0;     // 1/s, with damping
        double bark = 0;
        double threshold = 0;
        double drive = 0; // Pa/√s, of the next block
        std::complex<double> state;
        std::complex<double> step; // of one sample; 0: not computed
        std::complex<double> leap; // of leapSamples
        int leapSamples = 0;       // 0: not computed
    };
    struct Impact {
        int sample = 0;
        std::vector<double> amplitudes;
    };
    void pack(std::span<std::uint8_t const> audible, ModalScratch& scratch);
    void leap(Oscillator& mode, int samples) const;
    void skip(Oscillator& mode, std::size_t index, int samples) const;
    [[nodiscard]] std::complex<double> turned(Oscillator const& mode, double samples) const;

    double rate_;
    std::vector<Oscillator> modes_;
    std::vector<Impact> impacts_; // ascending by sample
    bool driven_ = false;
};

} // namespace trembler
