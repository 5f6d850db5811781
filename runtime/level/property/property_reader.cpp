#include "runtime/level/property/property_reader.hpp"

#include "runtime/level/json/limits.hpp"
#include "runtime/level/json/suggestion.hpp"
#include "runtime/level/json/text_limits.hpp"
#include "runtime/level/property/field_outline.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace trembler {
namespace {

/// The range of a field in the unit of the file, and in words.
struct Range {
    explicit Range(FieldInfo const& info)
        : minimum(info.minimum), maximum(info.maximum), excluded(info.minimumExcluded), unit(info.unit) {
        if (isAngle(info.unit)) {
            minimum = widened(minimum);
            maximum = widened(maximum);
            unit = info.unit == "rad" ? "degrees" : "degrees/s";
        }
    }
    [[nodiscard]] bool contains(double v) const {
        return std::isfinite(v) && (excluded ? v > minimum : v >= minimum) && v <= maximum;
    }
    [[nodiscard]] std::string words(std::string_view what) const {
        constexpr double all = std::numeric_limits<double>::max();
        std::string text(what);
        if (minimum > -all && maximum < all) {
            text += excluded ? fmt::format(" above {} and at most {}", shown(minimum), shown(maximum))
                             : fmt::format(" from {} to {}", shown(minimum), shown(maximum));
        } else if (minimum > -all) {
            text += (excluded ? " above " : " of at least ") + shown(minimum);
        } else if (maximum < all) {
            text += fmt::format(" of at most {}", shown(maximum));
        }
        return unit.empty() ? text : fmt::format("{} ({})", text, unit);
    }

    double minimum;
    double maximum;
    bool excluded;
    std::string unit;

private:
    static double widened(double limit) {
        return std::abs(limit) == std::numeric_limits<double>::max() ? limit : degrees(limit);
    }
};

class FieldReader final : public FieldVisitor {
public:
    /// Reads an object with one member per field or, if `bare`, a single value.
    FieldReader(JsonNode node, bool bare, NameTable* names)
        : node_(std::move(node)), bare_(bare), names_(names) {}

    [[nodiscard]] bool good() const { return good_; }
    [[nodiscard]] std::vector<std::string> const& keys() const { return keys_; }

    void boolean(FieldInfo const& info, bool& value) override {
        take(info, value, [&](JsonNode const& node) { return node.boolean(); });
    }
    void integer(FieldInfo const& info, std::int32_t& value) override {
        take(info, value, [&](JsonNode const& node) -> std::optional<std::int32_t> {
            constexpr double lowest = std::numeric_limits<std::int32_t>::min();
            constexpr double highest = std::numeric_limits<std::int32_t>::max();
            auto const whole =
                node.integer(static_cast<std::int64_t>(std::ceil(std::max(lowest, limits(info).minimum))),
                             static_cast<std::int64_t>(std::floor(std::min(highest, limits(info).maximum))));
            return whole ? std::optional(static_cast<std::int32_t>(*whole)) : std::nullopt;
        });
    }
    void number(FieldInfo const& info, double& value) override {
        take(info, value, [&](JsonNode const& node) { return readNumber(limits(info), node); });
    }
    void vector(FieldInfo const& info, Vec2& value) override {
        take(info, value, [&](JsonNode const& node) -> std::optional<Vec2> {
            if (!node.value().is_array() || node.size() != 2) {
                node.complainOfType("a list [x, y] of two numbers");
                return std::nullopt;
            }
            auto const x = readNumber(limits(info), node.element(0));
            auto const y = readNumber(limits(info), node.element(1));
            return x && y ? std::optional(Vec2{*x, *y}) : std::nullopt;
        });
    }
    void text(FieldInfo const& info, std::string& value) override {
        take(info, value, [&](JsonNode const& node) {
            auto stated = node.text();
            if (stated && stated->size() > trembler::limits::textInProperty) {
                node.complain(fmt::format("has {} bytes", stated->size()),
                              fmt::format("at most {}", trembler::limits::textInProperty));
                stated.reset();
            }
            return stated;
        });
    }
    void object(FieldInfo const& info, ObjectId& value) override {
        take(info, value, [&](JsonNode const& node) -> std::optional<ObjectId> {
            if (names_ == nullptr) {
                node.complain("refers to an object, but here there are none", "no such key");
                return std::nullopt;
            }
            auto const name = node.name("the name of an object");
            return name ? std::optional(names_->refer(*name)) : std::nullopt;
        });
    }
    void choice(FieldInfo const& info, ChoiceField field) override {
        take(info, field.index, [&](JsonNode const& node) -> std::optional<int> {
            auto const found = node.choice(field.names);
            return found ? std::optional(static_cast<int>(*found)) : std::nullopt;
        });
    }
    void list(FieldInfo const& info, ListField& field) override {
        auto const node = find(info);
        if (!node) {
            return;
        }
        if (!node->isList(fmt::format("a list ({})", info.meaning), info.most)) {
            good_ = false;
            return;
        }
        field.resize(node->size());
        for (std::size_t i = 0; i < node->size(); ++i) {
            readElement(info, field, i, node->element(i));
        }
    }
    void refuseUnknownKeys(std::span<std::string const> others) {
        std::vector<std::string> known = keys_;
        known.insert(known.end(), others.begin(), others.end());
        for (auto const& [key, value] : node_.value().items()) {
            if (std::find(known.begin(), known.end(), key) == known.end()) {
                good_ = false;
                node_.complainAboutKey(key, fmt::format("unknown key '{}'{}", key, didYouMean(key, known)),
                                       listed(known));
            }
        }
    }

private:
    /// A list element without fields has the range and the unit of its list.
    [[nodiscard]] FieldInfo const& limits(FieldInfo const& info) const {
        return listInfo_ == nullptr ? info : *listInfo_;
    }
    std::optional<double> readNumber(FieldInfo const& info, JsonNode const& node) {
        Range const range(info);
        if (node.value().is_number()) {
            auto const stated = node.value().get<double>();
            if (range.contains(stated)) {
                return isAngle(info.unit) ? radians(stated) : stated;
            }
        }
        node.complainOfType(range.words("a number"));
        return std::nullopt;
    }
    std::optional<JsonNode> find(FieldInfo const& info) {
        std::string const key(info.key);
        if (bare_) {
            return node_;
        }
        keys_.push_back(key);
        if (node_.has(key)) {
            return node_.member(key);
        }
        if (info.required) {
            good_ = false;
            node_.complain(fmt::format("'{}' is missing", key), std::string(info.meaning));
        }
        return std::nullopt;
    }
    template <class T, class Read>
    void take(FieldInfo const& info, T& value, Read&& read) {
        auto const node = find(info);
        if (!node) {
            return;
        }
        if (auto const stated = read(*node)) {
            value = *stated;
        } else {
            good_ = false;
        }
    }
    void readElement(FieldInfo const& info, ListField& field, std::size_t index, JsonNode const& node) {
        bool const hasFields = field.elementsHaveFields();
        if (hasFields && !node.isObject(fmt::format("an object, one of: {}", info.meaning))) {
            good_ = false;
            return;
        }
        FieldReader reader(node, !hasFields, names_);
        reader.listInfo_ = hasFields ? nullptr : &info;
        field.visitElement(index, reader);
        if (hasFields) {
            reader.refuseUnknownKeys({});
        }
        good_ = good_ && reader.good_;
    }

    JsonNode node_;
    bool bare_;
    NameTable* names_;
    FieldInfo const* listInfo_ = nullptr;
    bool good_ = true;
    std::vector<std::string> keys_;
};

std::string_view wordsFor(PropertyPlace place) {
    switch (place) {
    case PropertyPlace::properties:
        return "it belongs under an object's \"properties\"";
    case PropertyPlace::placement:
        return "it belongs directly in an object's entry";
    case PropertyPlace::world:
        return "it belongs under the level's \"world\"";
    case PropertyPlace::hidden:
        return "it arises only while the world runs";
    }
    return "";
}

/// Whether `false` can only mean that the object does not have the property.
bool falseTakesAway(PropertyInfo const& info) {
    auto const value = info.makeValue();
    auto const fields = outlineOf(*value);
    return !isBare(fields) || fields.front().type != FieldType::boolean;
}

} // namespace

std::unique_ptr<PropertyValue> readPropertyBeside(PropertyInfo const& info, JsonNode const& node,
                                                  NameTable* names, std::span<std::string const> others) {
    if (!node.isObject(fmt::format("an object with the fields of '{}'", info.text.key))) {
        return nullptr;
    }
    auto value = info.makeValue();
    FieldReader reader(node, false, names);
    value->visit(reader);
    reader.refuseUnknownKeys(others);
    return reader.good() ? std::move(value) : nullptr;
}

std::unique_ptr<PropertyValue> readProperty(PropertyInfo const& info, JsonNode const& node,
                                            NameTable* names) {
    auto value = info.makeValue();
    auto const fields = outlineOf(*value);
    if (fields.empty()) {
        if (node.value() != true) {
            node.complainOfType("true, as it has no fields, or false to remove it");
            return nullptr;
        }
        return value;
    }
    if (isBare(fields)) {
        FieldReader reader(node, true, names);
        value->visit(reader);
        return reader.good() ? std::move(value) : nullptr;
    }
    if (node.value() == true) {
        for (FieldOutline const& field : fields) {
            if (field.info.required) {
                node.complain(fmt::format("is true, but '{}' must be stated", field.info.key), "an object");
                return nullptr;
            }
        }
        return value;
    }
    return readPropertyBeside(info, node, names, {});
}

void readPropertyInto(PropertySet& set, PropertyInfo const& info, JsonNode const& node, NameTable* names) {
    if (node.value() == false && falseTakesAway(info)) {
        set.takeAway(info);
    } else if (auto value = readProperty(info, node, names)) {
        set.set(std::move(value));
    }
}

void readProperties(PropertySet& set, Registry const& registry, PropertyPlace place, JsonNode const& node,
                    NameTable* names) {
    if (!node.isObject("an object with one member per property")) {
        return;
    }
    for (auto const& [key, value] : node.value().items()) {
        PropertyInfo const* const info = registry.objectProperty(key);
        if (info == nullptr) {
            auto const known = keysOf(registry, place);
            node.complainAboutKey(key, fmt::format("unknown property '{}'{}", key, didYouMean(key, known)),
                                  listed(known));
        } else if (info->text.place != place) {
            node.complainAboutKey(key, fmt::format("'{}' cannot be stated here", key),
                                  std::string(wordsFor(info->text.place)));
        } else {
            readPropertyInto(set, *info, node.member(key), names);
        }
    }
}

std::vector<std::string> keysOf(Registry const& registry, PropertyPlace place) {
    std::vector<std::string> keys;
    for (PropertyInfo const* info : registry.objectProperties()) {
        if (info->text.place == place) {
            keys.emplace_back(info->text.key);
        }
    }
    return keys;
}

} // namespace trembler
