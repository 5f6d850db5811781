#include "runtime/population/birth_name.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>

namespace trembler {
namespace {

constexpr std::string_view between = " of ";

/// Removes a decimal number, as fmt prints it, from the end of a text; does not change the text if there is
/// none.
std::optional<std::uint64_t> takeNumber(std::string_view& text) {
    std::size_t const before = text.find_last_not_of("0123456789");
    std::string_view const digits = text.substr(before == std::string_view::npos ? 0 : before + 1);
    std::uint64_t number = 0;
    auto const [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    bool const leadingZero = digits.size() > 1 && digits.front() == '0';
    if (error != std::errc() || leadingZero) { // no digits, or too many
        return std::nullopt;
    }
    text.remove_suffix(digits.size());
    return number;
}

bool takeSuffix(std::string_view& text, std::string_view suffix) {
    bool const there = text.ends_with(suffix);
    text.remove_suffix(there ? suffix.size() : 0);
    return there;
}

/// "PART of MAKER NUMBER"
bool isPlain(std::string_view name) {
    if (!takeNumber(name) || !takeSuffix(name, " ")) {
        return false;
    }
    std::size_t const at = name.find(between, 1); // the part has at least one character
    return at != std::string_view::npos && at + between.size() < name.size();
}

} // namespace

std::string birthName(std::string_view part, std::string_view maker, std::uint64_t number,
                      std::uint64_t attempt) {
    std::string const plain = fmt::format("{}{}{} {}", part, between, maker, number);
    return attempt < 2 ? plain : fmt::format("{} ({})", plain, attempt);
}

bool isBirthName(std::string_view name) {
    if (isPlain(name)) {
        return true;
    }
    if (!takeSuffix(name, ")")) {
        return false;
    }
    auto const attempt = takeNumber(name);
    return attempt && *attempt >= 2 && takeSuffix(name, " (") && isPlain(name);
}

} // namespace trembler
