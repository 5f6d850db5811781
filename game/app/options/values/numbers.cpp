#include "game/app/options/values/numbers.hpp"

#include <charconv>
#include <cmath>
#include <system_error>

namespace trembler {
namespace {

bool hasLeadingZero(std::string_view text) {
    std::string_view const digits = text.substr(text.starts_with('-') ? 1 : 0);
    return digits.size() > 1 && digits[0] == '0' && digits[1] >= '0' && digits[1] <= '9';
}

template <class Number>
std::optional<Number> whole(std::string_view text, Number least, Number most) {
    Number number{};
    char const* const end = text.data() + text.size();
    auto const [stop, error] = std::from_chars(text.data(), end, number);
    bool const good = error == std::errc() && stop == end && !hasLeadingZero(text);
    return good && number >= least && number <= most ? std::optional(number) : std::nullopt;
}

} // namespace

std::optional<std::int64_t> wholeNumber(std::string_view text, std::int64_t least, std::int64_t most) {
    return whole(text, least, most);
}

std::optional<double> decimalNumber(std::string_view text, double least, double most) {
    return whole(text, least, most); // not-a-number is in no range
}

} // namespace trembler
