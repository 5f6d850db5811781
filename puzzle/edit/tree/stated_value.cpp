#include "puzzle/edit/tree/stated_value.hpp"

#include "puzzle/edit/tree/object_values.hpp"
#include "puzzle/edit/tree/tree_access.hpp"
#include "runtime/level/property/field_outline.hpp"
#include "runtime/level/property/property_writer.hpp"
#include "runtime/property/idle_visitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace trembler::edit {
namespace {

using Pointer = Json::json_pointer;

/// The token of a list's entry; nothing for anything else.
std::optional<std::size_t> indexIn(std::string const& token) {
    bool const digits = !token.empty() && token.size() < 9 &&
                        std::all_of(token.begin(), token.end(), [](char c) { return c >= '0' && c <= '9'; });
    return digits ? std::optional<std::size_t>(std::stoul(token)) : std::nullopt;
}

std::vector<std::string> tokensOf(std::string const& place) {
    Pointer const whole = [&] {
        try {
            return Pointer(place);
        } catch (Json::exception const&) {
            throw CommandError(fmt::format("'{}' is no place in a property", place));
        }
    }();
    std::vector<std::string> tokens;
    for (Pointer rest = whole; !rest.empty(); rest = rest.parent_pointer()) {
        tokens.insert(tokens.begin(), rest.back());
    }
    return tokens;
}

/// Brings the numbers of a new entry into their ranges.
class IntoRange final : public IdleVisitor {
public:
    void integer(FieldInfo const& info, std::int32_t& value) override {
        if (value < info.minimum) {
            value = static_cast<std::int32_t>(info.minimum);
        }
    }
    void number(FieldInfo const& info, double& value) override {
        if (value < info.minimum || (info.minimumExcluded && value <= info.minimum)) {
            value =
                info.minimumExcluded ? std::min(std::max(1.0, 2 * info.minimum), info.maximum) : info.minimum;
        }
    }
};

/// Adds an entry to the list at a place of a value.
class ListGrower final : public IdleVisitor {
public:
    /// `at` is the first token about the value; `bare`: it is a single field, which no token names.
    ListGrower(std::vector<std::string> const& tokens, std::size_t at, bool bare)
        : tokens_(tokens), at_(at), bare_(bare) {}

    bool grown = false;

    void list(FieldInfo const& info, ListField& field) override {
        std::size_t const inside = bare_ ? at_ : at_ + 1;
        if (!bare_ && (at_ >= tokens_.size() || tokens_[at_] != info.key)) {
            return;
        }
        if (inside >= tokens_.size()) {
            if (field.size() < info.most) {
                field.resize(field.size() + 1);
                IntoRange range;
                field.visitElement(field.size() - 1, range);
                grown = true;
            }
            return;
        }
        if (auto const index = indexIn(tokens_[inside]); index && *index < field.size()) {
            ListGrower inner(tokens_, inside + 1, !field.elementsHaveFields());
            field.visitElement(*index, inner);
            grown = inner.grown;
        }
    }

private:
    std::vector<std::string> const& tokens_;
    std::size_t at_;
    bool bare_;
};

} // namespace

Json initialStatement(PropertyInfo const& info) {
    auto const value = info.makeValue();
    auto const fields = outlineOf(*value);
    if (info.text.key == "shape") { // a list of pieces must not be empty
        return Json::array({Json{{"form", "box"}}});
    }
    if (fields.empty()) {
        return true;
    }
    if (isBare(fields) && fields.front().type == FieldType::boolean) {
        return true;
    }
    Json written = writeProperty(*value);
    NameTable names;
    if (readValue(info, written, names)) {
        return written;
    }
    // A required number whose initial value is out of range: the nearest round one within.
    auto const within = [](FieldInfo const& field) {
        double const least = isAngle(field.unit) ? degrees(field.minimum) : field.minimum;
        return numberJson(field.minimumExcluded || least <= 0 ? std::max(1.0, least) : least);
    };
    for (FieldOutline const& field : fields) {
        if (!isNumber(field)) {
            continue;
        }
        if (isBare(fields)) {
            written = within(field.info);
        } else if (field.info.required) {
            if (!written.is_object()) {
                written = Json::object();
            }
            written[std::string(field.info.key)] = within(field.info);
        }
    }
    return written;
}

Json withRequiredObjects(PropertyInfo const& info, Json stated, std::string const& name) {
    auto const value = info.makeValue();
    for (FieldOutline const& field : outlineOf(*value)) {
        std::string const key(field.info.key);
        if (field.type != FieldType::object || !field.info.required) {
            continue;
        }
        if (!stated.is_object()) {
            stated = Json::object();
        }
        if (!stated.contains(key)) {
            stated[key] = name;
        }
    }
    return stated;
}

void setAt(Json& value, std::string const& field, Json const& to) {
    if (field.empty()) {
        value = to;
        return;
    }
    std::vector<std::string> const tokens = tokensOf(field);
    Json* node = &value;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        bool const last = i + 1 == tokens.size();
        if (node->is_array()) {
            auto const index = indexIn(tokens[i]);
            if (!index || *index >= node->size()) {
                throw CommandError(fmt::format("there is no entry '{}'", tokens[i]));
            }
            node = &(*node)[*index];
        } else {
            if (!node->is_object()) { // `true` stands for initial values
                *node = Json::object();
            }
            if (last && to.is_null()) {
                node->erase(tokens[i]);
                return;
            }
            node = &(*node)[tokens[i]];
        }
    }
    *node = to;
}

Json withOneMore(PropertyInfo const& info, Json const& value, std::string const& list) {
    NameTable names;
    std::string why;
    auto const read = readValue(info, value.is_null() ? initialStatement(info) : value, names, &why);
    if (!read) {
        throw CommandError(fmt::format("{}: {}", info.text.name, why));
    }
    std::vector<std::string> const tokens = tokensOf(list);
    ListGrower grower(tokens, 0, isBare(outlineOf(*read)));
    read->visit(grower);
    if (!grower.grown) {
        throw CommandError("there is no such entry");
    }
    Json const written = writeProperty(*read, names);
    Pointer const place(list);
    if (!written.contains(place) || !written[place].is_array()) {
        throw CommandError("there is no such entry");
    }
    // Only the new entry is as it was written here: the rest keeps its spelling.
    Json made = value.is_null() ? initialStatement(info) : value;
    bool const there = (list.empty() || made.is_object() || made.is_array()) && made.contains(place) &&
                       made[place].is_array();
    Json entries = there ? made[place] : Json::array();
    entries.push_back(written[place].back());
    setAt(made, list, entries);
    return made;
}

void mustBeReadable(PropertyInfo const& info, Json const& value) {
    NameTable names;
    std::string why;
    if (!readValue(info, value, names, &why)) {
        throw CommandError(fmt::format("{}: {}", info.text.name, why));
    }
}

std::string propertyInWords(PropertyInfo const& info) {
    std::string words(info.text.name);
    if (words.size() > 1 && words[1] >= 'a' && words[1] <= 'z' && words[0] >= 'A' && words[0] <= 'Z') {
        words[0] = static_cast<char>(words[0] - 'A' + 'a');
    }
    return words;
}

} // namespace trembler::edit
