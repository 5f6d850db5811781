#include "lua/binding/vocabulary.hpp"
#include "puzzle/data/effects.hpp"
#include "tests/fuzz/play.hpp"
#include "tests/fuzz/targets.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace trembler::lua {
namespace {

/// Turns bytes into decisions; zeros when there are no more.
class Bytes {
public:
    explicit Bytes(std::string_view bytes) : bytes_(bytes) {}
    [[nodiscard]] bool more() const { return !bytes_.empty(); }
    unsigned next() {
        if (bytes_.empty()) {
            return 0;
        }
        auto const byte = static_cast<unsigned char>(bytes_.front());
        bytes_.remove_prefix(1);
        return byte;
    }
    /// Below `count`.
    std::size_t pick(std::size_t count) { return count == 0 ? 0 : (next() | next() << 8U) % count; }
    double any() {
        std::uint64_t bits = 0;
        for (unsigned i = 0; i < 8; ++i) {
            bits |= std::uint64_t{next()} << (8 * i);
        }
        double value = 0;
        std::memcpy(&value, &bits, sizeof value);
        return value;
    }
    double share() { return static_cast<double>(next()) / 255; }

private:
    std::string_view bytes_;
};

std::string lua(double value) {
    if (std::isnan(value)) {
        return "(0 / 0)";
    }
    if (std::isinf(value)) {
        return value > 0 ? "math.huge" : "-math.huge";
    }
    return fmt::format("({:.17g})", value);
}

class CallWriter {
public:
    CallWriter(Bytes& bytes, Vocabulary const& vocabulary) : bytes_(bytes), vocabulary_(vocabulary) {}

    std::string script() {
        auto const roles = vocabulary_.roleNames();
        std::string const name = roles[bytes_.pick(roles.size())];
        role_ = vocabulary_.role(name);
        constexpr std::array<std::string_view, 5> applications{
            "each = { \"Position\" }", "once = true",
            "pairs = { first = { \"Position\" }, second = { \"Mass\" }, within = 2 }",
            "pairs = { first = { \"Position\" }, second = { \"Position\" }, touching = true }",
            "each = { \"Conductor\" }"};
        std::size_t const application = bytes_.pick(applications.size());
        bool const two = application == 2 || application == 3;
        std::string calls;
        for (int count = 0; count < 12 && bytes_.more(); ++count) {
            calls += call();
        }
        return fmt::format(
            "return interaction {{ name = \"{0} <- Fuzz\", calls = \"{0}\",\n"
            "  reads = {{ \"Position\", \"Mass\", \"Conductor\", \"Joint\", \"G_E\", \"contacts\" }}, {1}, "
            "restless = {2},\n"
            "  apply = function({3}, params, out, store, frame)\n"
            "    local objects = {{ {4}, world }}\n"
            "    for _, list in ipairs({{ world.contacts.current, world.contacts.ended }}) do\n"
            "      for i = 1, math.min(#list, 5) do\n"
            "        objects[#objects + 1] = list[i].a\n        objects[#objects + 1] = list[i].b\n"
            "      end\n    end\n"
            "    local function object(i) return objects[i % #objects + 1] end\n{5}  end }}\n",
            role_->name, applications[application], bytes_.next() % 2 == 0 ? "true" : "false",
            two ? "a, b" : "a", two ? "a, b" : "a", calls);
    }

private:
    std::string call() {
        CallDescription const& made = role_->calls[bytes_.pick(role_->calls.size())];
        bool const named = bytes_.next() % 2 == 0;
        bool const caught = bytes_.next() % 4 != 0; // so that the following calls are made, too
        std::string arguments;
        for (FieldPlace const& place : made.arguments) {
            if (bytes_.next() % 16 == 0) {
                if (named) {
                    continue; // left out
                }
                break;
            }
            arguments += fmt::format("{}{}{}", arguments.empty() ? "" : ", ",
                                     named ? std::string(place.info.key) + " = " : "", argument(place));
        }
        if (bytes_.next() % 32 == 0) {
            arguments += fmt::format("{}{}", arguments.empty() ? "" : ", ", named ? "more = 1" : "1");
        }
        std::string const statement = named ? fmt::format("out.{}{{ {} }}", made.text.name, arguments)
                                            : fmt::format("out.{}({})", made.text.name, arguments);
        return caught ? fmt::format("    pcall(function() {} end)\n", statement)
                      : fmt::format("    {}\n", statement);
    }

    std::string argument(FieldPlace const& place) {
        switch (bytes_.next() % 8) { // mostly valid values
        case 0:
            return anything();
        case 1:
            return extreme(place);
        default:
            return fitting(place);
        }
    }

    std::string number(FieldPlace const& place) {
        double const low = std::max(place.info.minimum, -1e3);
        double const high = std::min(place.info.maximum, 1e3);
        return lua(low + (high - low) * bytes_.share());
    }

    std::string fitting(FieldPlace const& place) {
        switch (place.kind) {
        case FieldKind::boolean:
            return bytes_.next() % 2 == 0 ? "true" : "false";
        case FieldKind::integer:
        case FieldKind::whole:
            return lua(bytes_.next());
        case FieldKind::number:
            return number(place);
        case FieldKind::vector: {
            std::string const x = number(place);
            return fmt::format("vec2({}, {})", x, number(place));
        }
        case FieldKind::object:
            return fmt::format("object({})", bytes_.next());
        case FieldKind::part:
            return bytes_.next() % 4 == 0 ? "\"lamp\"" : "\"rubber ball\"";
        case FieldKind::choice:
            return place.choices.empty()
                       ? "\"\""
                       : fmt::format("\"{}\"", place.choices[bytes_.pick(place.choices.size())]);
        default:
            return "\"text\"";
        }
    }

    std::string extreme(FieldPlace const& place) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        std::array<double, 8> const values{place.info.minimum,
                                           place.info.maximum,
                                           std::nextafter(place.info.minimum, -infinity),
                                           std::nextafter(place.info.maximum, infinity),
                                           0,
                                           -0.0,
                                           4.9e-324,
                                           bytes_.any()};
        double const value = values[bytes_.pick(values.size())];
        if (place.kind == FieldKind::vector) {
            return fmt::format("vec2({}, {})", lua(value), lua(values[bytes_.pick(values.size())]));
        }
        return lua(value);
    }

    std::string anything() {
        constexpr std::array<std::string_view, 14> values{"nil",
                                                          "true",
                                                          "\"text\"",
                                                          "{}",
                                                          "function() end",
                                                          "coroutine.create(function() end)",
                                                          "out",
                                                          "store",
                                                          "vec2(0 / 0, math.huge)",
                                                          "{ x = 1, y = 2 }",
                                                          "setmetatable({}, { __index = object })",
                                                          "params",
                                                          "world",
                                                          "(0 / 0)"};
        std::size_t const index = bytes_.pick(values.size() + 1);
        return index < values.size() ? std::string(values[index]) : lua(bytes_.any());
    }

    Bytes& bytes_;
    Vocabulary const& vocabulary_;
    RoleInfo const* role_ = nullptr;
};

Vocabulary const& vocabularyOfAll() {
    static Registry const registry = [] {
        Registry made;
        registerEffects(made);
        return made;
    }();
    static Vocabulary const vocabulary(registry);
    return vocabulary;
}

} // namespace

std::string scriptOfCalls(std::string_view bytes) {
    Bytes source(bytes);
    return CallWriter(source, vocabularyOfAll()).script();
}

void fuzzCallArguments(std::string_view bytes) {
    playTwice(scriptOfCalls(bytes), 12);
}

} // namespace trembler::lua
