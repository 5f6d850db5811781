// What was changed, while a world ran, about how exactly it is computed. Recorded by frame like what the
// player did, it makes the run repeatable.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace trembler {

struct RecordedChange {
    enum class Kind : std::uint8_t {
        detail,  ///< `subject`, an effect, goes to the detail level `level`; "" leaves it to the scene
        period,  ///< `subject`, the title of a component, runs in every `value`th frame
        setting, ///< `field` of the world's property with the key `subject` becomes `value`
    };
    std::uint64_t frame = 1; ///< the first frame that it counts for, from 1
    Kind kind = Kind::detail;
    std::string subject;
    std::string field;
    std::string level;
    double value = 0;
    std::string path; ///< in the file, for messages; empty if it came from elsewhere
};

/// The names of the kinds, as files spell them, in order.
inline constexpr std::string_view recordedChangeNames[] = {"detail", "period", "setting"};

} // namespace trembler
