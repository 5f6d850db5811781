#include "game/app/options/values/picture_size.hpp"

#include "game/app/options/rule/rule.hpp"
#include "game/app/options/values/numbers.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace trembler {
namespace {

constexpr std::int64_t smallestSide = 16;         // pixels
constexpr std::int64_t largestSide = 16384;       // pixels
constexpr std::int64_t mostPixels = 8192L * 8192; // an image of a quarter of a gigabyte

} // namespace

std::optional<PictureSize> pictureSizeFrom(std::string const& text) {
    std::size_t const cross = text.find('x');
    // Without an x the height is empty, which is not a number and is refused below.
    std::string const behind = cross == std::string::npos ? "" : text.substr(cross + 1);
    auto const width = wholeNumber(text.substr(0, cross), smallestSide, largestSide);
    auto const height = wholeNumber(behind, smallestSide, largestSide);
    if (!width || !height || *width * *height > mostPixels) {
        return std::nullopt;
    }
    return PictureSize{static_cast<int>(*width), static_cast<int>(*height)};
}

CLI::Option* addPictureSize(CLI::App& command, std::string& size) {
    auto* const added = command.add_option("--size", size,
                                           fmt::format("Pixels, {} to {} each way and at most {} in all",
                                                       smallestSide, largestSide, mostPixels));
    return accepts(added->capture_default_str()->type_name("WIDTHxHEIGHT"),
                   fmt::format("WIDTHxHEIGHT in pixels, {} to {} each and at most {} together, like 1280x720",
                               smallestSide, largestSide, mostPixels),
                   [](std::string const& text) { return pictureSizeFrom(text) ? Fault() : Fault(""); });
}

} // namespace trembler
