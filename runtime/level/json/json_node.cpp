#include "runtime/level/json/json_node.hpp"

#include "runtime/file/visible_text.hpp"
#include "runtime/level/json/add_problem.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/level/json/text_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace trembler {
namespace {

std::string shownValue(nlohmann::json const& value) {
    if (value.is_object()) {
        return "an object {...}";
    }
    if (value.is_array()) {
        return fmt::format("a list of {}", value.size());
    }
    std::string text = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    constexpr std::size_t longest = 60;
    if (text.size() > longest) {
        std::size_t cut = longest;
        while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0U) == 0x80U) {
            --cut; // do not cut inside a character
        }
        text = text.substr(0, cut) + "...";
    }
    return text;
}

std::string shownRange(double minimum, double maximum) {
    constexpr double all = std::numeric_limits<double>::max();
    if (minimum == -all && maximum == all) {
        return "a number";
    }
    if (maximum == all) {
        return fmt::format("a number of at least {}", shown(minimum));
    }
    if (minimum == -all) {
        return fmt::format("a number of at most {}", shown(maximum));
    }
    return fmt::format("a number from {} to {}", shown(minimum), shown(maximum));
}

} // namespace

std::string shown(double number) {
    return fmt::format("{}", number);
}

JsonNode JsonNode::member(std::string const& key) const {
    return {*document_, value_->at(key), pointerTo(path_, key), *problems_};
}

JsonNode JsonNode::element(std::size_t index) const {
    return {*document_, value_->at(index), pointerTo(path_, index), *problems_};
}

void JsonNode::complain(std::string message, std::string expected) const {
    addProblem(*problems_, [&] { return diagnostic(std::move(message), std::move(expected)); });
}

Diagnostic JsonNode::diagnostic(std::string message, std::string expected) const {
    return document_->diagnostic(path_, std::move(message), std::move(expected));
}

void JsonNode::complainAboutKey(std::string const& key, std::string message, std::string expected) const {
    addProblem(*problems_, [&] {
        return document_->diagnostic(pointerTo(path_, key), std::move(message), std::move(expected),
                                     Spot::key);
    });
}

void JsonNode::complainOfType(std::string expected) const {
    complain(fmt::format("is {}", shownValue(*value_)), std::move(expected));
}

bool JsonNode::isObject(std::string_view expected) const {
    if (!value_->is_object()) {
        complainOfType(std::string(expected));
    }
    return value_->is_object();
}

bool JsonNode::isArray(std::string_view expected) const {
    if (!value_->is_array()) {
        complainOfType(std::string(expected));
    }
    return value_->is_array();
}

bool JsonNode::isList(std::string_view expected, std::size_t most) const {
    if (isArray(expected) && value_->size() > most) {
        complain(fmt::format("has {} entries", value_->size()), fmt::format("at most {}", most));
    }
    return value_->is_array() && value_->size() <= most;
}

std::optional<bool> JsonNode::boolean(std::string_view expected) const {
    if (!value_->is_boolean()) {
        complainOfType(std::string(expected));
        return std::nullopt;
    }
    return value_->get<bool>();
}

std::optional<std::string> JsonNode::text(std::string_view expected) const {
    if (!value_->is_string()) {
        complainOfType(std::string(expected));
        return std::nullopt;
    }
    if (std::size_t const size = value_->get_ref<std::string const&>().size(); size > limits::text) {
        complain(fmt::format("has {} bytes", size), fmt::format("at most {}", limits::text));
        return std::nullopt;
    }
    return value_->get<std::string>();
}

std::optional<double> JsonNode::number(double minimum, double maximum) const {
    if (value_->is_number()) {
        auto const number = value_->get<double>();
        if (std::isfinite(number) && number >= minimum && number <= maximum) {
            return number;
        }
    }
    complainOfType(shownRange(minimum, maximum));
    return std::nullopt;
}

std::optional<std::int64_t> JsonNode::integer(std::int64_t minimum, std::int64_t maximum) const {
    constexpr double exact =
        9007199254740992.0; // 2^53: up to here a double represents every whole number exactly
    if (value_->is_number()) {
        auto const number = value_->get<double>();
        if (number == std::floor(number) && std::abs(number) <= exact) {
            auto const whole = static_cast<std::int64_t>(number);
            if (whole >= minimum && whole <= maximum) {
                return whole;
            }
        }
    }
    complainOfType(fmt::format("a whole number from {} to {}", minimum, maximum));
    return std::nullopt;
}

std::optional<Vec2> JsonNode::vector(double minimum, double maximum) const {
    if (!value_->is_array() || value_->size() != 2) {
        complainOfType("a list [x, y] of two numbers");
        return std::nullopt;
    }
    auto const x = element(0).number(minimum, maximum);
    auto const y = element(1).number(minimum, maximum);
    return x && y ? std::optional(Vec2{*x, *y}) : std::nullopt;
}

std::optional<std::size_t> JsonNode::choice(std::span<std::string_view const> names) const {
    std::vector<std::string> const known(names.begin(), names.end());
    if (value_->is_string()) {
        auto const& name = value_->get_ref<std::string const&>();
        auto const at = std::find(names.begin(), names.end(), name);
        if (at != names.end()) {
            return static_cast<std::size_t>(at - names.begin());
        }
        complain(fmt::format("is {}{}", shownValue(*value_), didYouMean(name, known)), listed(known));
        return std::nullopt;
    }
    complainOfType(listed(known));
    return std::nullopt;
}

std::optional<std::string> JsonNode::name(std::string_view what) const {
    constexpr std::size_t longest = 100;
    auto found = text(what);
    if (!found) {
        return std::nullopt;
    }
    if (found->empty() || found->size() > longest || hasControlCharacter(*found) || found->front() == ' ' ||
        found->back() == ' ') {
        complainOfType(
            fmt::format("{} of 1 to {} bytes in one line, without blanks at its ends", what, longest));
        return std::nullopt;
    }
    return found;
}

MemberReader::MemberReader(JsonNode node, std::string_view expected)
    : node_(std::move(node)), valid_(node_.isObject(expected)) {}

std::optional<JsonNode> MemberReader::optional(std::string const& key) {
    known_.insert(key);
    return valid_ && node_.has(key) ? std::optional(node_.member(key)) : std::nullopt;
}

std::optional<JsonNode> MemberReader::required(std::string const& key, std::string_view expected) {
    auto found = optional(key);
    if (!found && valid_) {
        node_.complain(fmt::format("'{}' is missing", key), std::string(expected));
    }
    return found;
}

void MemberReader::finish() const {
    if (!valid_) {
        return;
    }
    std::vector<std::string> const known(known_.begin(), known_.end());
    for (auto const& [key, value] : node_.value().items()) {
        if (!known_.contains(key)) {
            node_.complainAboutKey(key, fmt::format("unknown key '{}'{}", key, didYouMean(key, known)),
                                   known.empty() ? "no keys" : listed(known));
        }
    }
}

} // namespace trembler
