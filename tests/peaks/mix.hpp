// The stereo mix of a run, as loudspeakers and files get it, measured.
#pragma once

#include "puzzle/session/session.hpp"

#include <cstdint>
#include <string>

namespace trembler::peaks {

struct Mix {
    double truePeak = 0; ///< dB of full scale, by ITU-R BS.1770-4
    double step = 0;     ///< the greatest difference of two consecutive samples; 2 from end to end
    double loudest = 0;  ///< dB of full scale: the mean square of the loudest tenth of a second
    std::uint64_t frames = 0;
};

/// Plays a level, with the solution of that name if it is not empty, for so many frames, into memory. Throws
/// as Session does.
[[nodiscard]] Mix mixOf(Registry const& registry, PartLibrary const& parts, LevelFile const& level,
                        std::string const& solution, std::uint64_t frames);

/// Why the mix is not acceptable: a true peak above -1 dB of full scale, or a step above half of it. Empty if
/// it is.
[[nodiscard]] std::string faultOf(Mix const& mix);

} // namespace trembler::peaks
