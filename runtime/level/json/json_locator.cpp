#include "runtime/level/json/json_locator.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

namespace trembler {
namespace {

/// Walks through valid JSON. Stops without an error at the end of the text, so that even invalid text is
/// safe.
class Walker {
public:
    Walker(std::string_view text, std::size_t at) : text_(text), at_(at) { skipSpace(); }

    [[nodiscard]] std::size_t at() const { return at_; }
    [[nodiscard]] char now() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    void step() {
        ++at_;
        skipSpace();
    }
    /// The raw token with its quotes; moves to the byte after it.
    std::string_view string() {
        std::size_t const begin = at_;
        for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
            if (text_[at_] == '\\') {
                ++at_;
            }
        }
        at_ = std::min(at_ + 1, text_.size());
        std::string_view const token = text_.substr(begin, at_ - begin);
        skipSpace();
        return token;
    }
    void skipValue() {
        std::size_t depth = 0;
        do {
            char const c = now();
            if (c == '"') {
                string();
                continue;
            }
            if (c == '{' || c == '[') {
                ++depth;
            } else if (c == '}' || c == ']') {
                --depth;
            } else if (depth == 0) { // a number, true, false or null
                while (at_ < text_.size() &&
                       std::string_view(",]} \t\r\n").find(now()) == std::string_view::npos) {
                    ++at_;
                }
                skipSpace();
                return;
            }
            step();
        } while (depth > 0 && at_ < text_.size());
    }

private:
    void skipSpace() {
        while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos) {
            ++at_;
        }
    }

    std::string_view text_;
    std::size_t at_;
};

std::string unescaped(std::string_view token) {
    std::string key;
    for (std::size_t i = 0; i < token.size(); ++i) {
        if (token[i] == '~' && i + 1 < token.size()) {
            key += token[++i] == '1' ? '/' : '~';
        } else {
            key += token[i];
        }
    }
    return key;
}

/// Whether a token with its quotes is this key. Most tokens have no escapes and need not be parsed.
bool stands(std::string_view token, std::string const& key) {
    if (token.find('\\') == std::string_view::npos) {
        return token.size() == key.size() + 2 && token.substr(1, key.size()) == key;
    }
    auto const name = nlohmann::json::parse(token, nullptr, false);
    return name.is_string() && name.get_ref<std::string const&>() == key;
}

struct Found {
    std::size_t key;
    std::size_t value;
};

std::optional<Found> findMember(std::string_view text, std::size_t object, std::string const& key,
                                bool last) {
    std::optional<Found> found;
    Walker walker(text, object);
    walker.step();
    while (walker.now() == '"') {
        std::size_t const keyAt = walker.at();
        bool const isKey = stands(walker.string(), key);
        walker.step(); // the colon
        if (isKey) {
            found = Found{keyAt, walker.at()};
            if (!last) {
                return found;
            }
        }
        walker.skipValue();
        if (walker.now() == ',') {
            walker.step();
        }
    }
    return found;
}

std::optional<Found> findElement(std::string_view text, std::size_t array, std::size_t index) {
    Walker walker(text, array);
    walker.step();
    for (std::size_t i = 0; walker.now() != ']' && walker.now() != '\0'; ++i) {
        if (i == index) {
            return Found{walker.at(), walker.at()};
        }
        walker.skipValue();
        if (walker.now() == ',') {
            walker.step();
        }
    }
    return std::nullopt;
}

} // namespace

TextPlace placeOf(std::string_view text, std::size_t offset) {
    std::string_view const before = text.substr(0, std::min(offset, text.size()));
    TextPlace place;
    place.line = 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    std::size_t const lineStart = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    std::string_view const line = before.substr(lineStart);
    place.column = 1 + static_cast<std::size_t>(std::count_if(line.begin(), line.end(), [](char c) {
                       return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
                   }));
    return place;
}

std::size_t locate(std::string_view text, std::string_view pointer, Spot spot) {
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    Found here{};
    here.value = here.key = Walker(text, text.starts_with(byteOrderMark) ? byteOrderMark.size() : 0).at();
    while (pointer.starts_with('/')) {
        std::size_t const end = pointer.find('/', 1);
        std::string const token = unescaped(pointer.substr(1, end == std::string_view::npos ? end : end - 1));
        pointer = end == std::string_view::npos ? std::string_view() : pointer.substr(end);
        std::optional<Found> next;
        char const kind = here.value < text.size() ? text[here.value] : '\0';
        if (kind == '{') {
            next = findMember(text, here.value, token, spot == Spot::lastKey && pointer.empty());
        } else if (kind == '[') {
            std::size_t index = std::numeric_limits<std::size_t>::max();
            std::from_chars(token.data(), token.data() + token.size(), index);
            next = findElement(text, here.value, index);
        }
        if (!next) {
            return here.value;
        }
        here = *next;
    }
    return spot == Spot::value ? here.value : here.key;
}

std::string pointerTo(std::string_view parent, std::string_view key) {
    std::string pointer(parent);
    pointer += '/';
    for (char const c : key) {
        if (c == '~') {
            pointer += "~0";
        } else if (c == '/') {
            pointer += "~1";
        } else {
            pointer += c;
        }
    }
    return pointer;
}

std::string pointerTo(std::string_view parent, std::size_t index) {
    return fmt::format("{}/{}", parent, index);
}

} // namespace trembler
