// The stereo mix of a run, as loudspeakers and files get it, measured.
#pragma once

#include "puzzle/session/session.hpp"
#include "tests/worlds/random_level.hpp"

#include <cstdint>
#include <functional>
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

/// The mixes of random worlds, those of tests/worlds, one after the other.
class RandomMixes {
public:
    /// Begins with the world of that seed.
    explicit RandomMixes(std::uint64_t seed = 0);
    struct Named {
        std::uint64_t seed = 0;
        Mix mix;
    };
    /// The next world that can be read, for so many frames, of those whose seeds are `wanted`; without it, of
    /// all. Leaves out those with all objects in one place,
    /// with whose contacts engines take long. The calling process must not have started a thread.
    [[nodiscard]] Named next(std::uint64_t frames, std::function<bool(std::uint64_t)> const& wanted = {});

private:
    nlohmann::json schema_;
    worlds::RandomLevels levels_;
    std::uint64_t seed_;
};

/// Why the mix is not acceptable: a true peak above -1 dB of full scale, or a step above half of it. Empty if
/// it is.
[[nodiscard]] std::string faultOf(Mix const& mix);

} // namespace trembler::peaks
