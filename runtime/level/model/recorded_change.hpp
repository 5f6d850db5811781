// A change, while a world runs, of how exactly it is computed. Recorded by frame, like player inputs, so that
// the run is repeatable.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace trembler {

struct RecordedChange {
    enum class Kind : std::uint8_t {
        detail,  ///< sets the detail level of the effect `subject` to `level`; "": the scene decides
        period,  ///< runs the component with the title `subject` in every `value`th frame
        setting, ///< sets `field` of the world's property with the key `subject` to `value`
    };
    std::uint64_t frame = 1; ///< the first frame that it affects, counted from 1
    Kind kind = Kind::detail;
    std::string subject;
    std::string field;
    std::string level;
    double value = 0;
    std::string path; ///< in the file, for messages; empty if it is not from a file
};

/// The names of the kinds, as files spell them, in order.
inline constexpr std::string_view recordedChangeNames[] = {"detail", "period", "setting"};

} // namespace trembler
