// Reads a JSON document step by step: every node knows its place and can complain about its value.
#pragma once

#include "runtime/level/json/json_document.hpp"
#include "runtime/math/vec2.hpp"

#include <optional>
#include <set>
#include <span>
#include <string>

namespace trembler {

/// One value of a document. The checked reads complain, and return nothing, if the value does not have the
/// expected form. The document, the value and the problems must outlive it.
class JsonNode {
public:
    JsonNode(JsonDocument const& document, nlohmann::json const& value, std::string path, Problems& problems)
        : document_(&document), value_(&value), path_(std::move(path)), problems_(&problems) {}

    [[nodiscard]] nlohmann::json const& value() const { return *value_; }
    [[nodiscard]] std::string const& path() const { return path_; }
    [[nodiscard]] Problems& problems() const { return *problems_; }
    /// A member or an element that is known to exist.
    [[nodiscard]] JsonNode member(std::string const& key) const;
    [[nodiscard]] JsonNode element(std::size_t index) const;
    [[nodiscard]] std::size_t size() const { return value_->size(); }
    [[nodiscard]] bool has(std::string const& key) const {
        return value_->is_object() && value_->contains(key);
    }

    void complain(std::string message, std::string expected = {}) const;
    /// The problem that complain() would add, for addProblem(): if its words are expensive to find.
    [[nodiscard]] Diagnostic diagnostic(std::string message, std::string expected = {}) const;
    /// Complains about a key of this object, at the key's place.
    void complainAboutKey(std::string const& key, std::string message, std::string expected = {}) const;
    /// Complains that the value is not of the expected type; the message contains the value.
    void complainOfType(std::string expected) const;

    [[nodiscard]] bool isObject(std::string_view expected) const;
    [[nodiscard]] bool isArray(std::string_view expected) const;
    /// Whether it is a list of at most `most` elements.
    [[nodiscard]] bool isList(std::string_view expected, std::size_t most) const;
    [[nodiscard]] std::optional<bool> boolean(std::string_view expected = "true or false") const;
    [[nodiscard]] std::optional<std::string> text(std::string_view expected = "text") const;
    [[nodiscard]] std::optional<double> number(double minimum, double maximum) const;
    [[nodiscard]] std::optional<std::int64_t> integer(std::int64_t minimum, std::int64_t maximum) const;
    /// [x, y], each within the range.
    [[nodiscard]] std::optional<Vec2> vector(double minimum, double maximum) const;
    /// One of the names; returns its number.
    [[nodiscard]] std::optional<std::size_t> choice(std::span<std::string_view const> names) const;
    /// A name for an object, a part or a solution: 1 to 100 bytes, no control characters, no blanks at the
    /// ends.
    [[nodiscard]] std::optional<std::string> name(std::string_view what) const;

private:
    JsonDocument const* document_;
    nlohmann::json const* value_;
    std::string path_;
    Problems* problems_;
};

/// Reads the members of an object and finally complains about all members that were not read.
class MemberReader {
public:
    /// Complains if the node is not an object; it then has no members.
    MemberReader(JsonNode node, std::string_view expected);
    [[nodiscard]] bool valid() const { return valid_; }
    [[nodiscard]] JsonNode const& node() const { return node_; }
    [[nodiscard]] std::optional<JsonNode> optional(std::string const& key);
    /// Complains if it is missing.
    [[nodiscard]] std::optional<JsonNode> required(std::string const& key, std::string_view expected);
    /// Declares keys that are read elsewhere.
    void know(std::string const& key) { known_.insert(key); }
    /// Complains about unknown keys and suggests similar known ones.
    void finish() const;

private:
    JsonNode node_;
    bool valid_;
    std::set<std::string> known_;
};

/// A number for people: the shortest text that reads back as the same double.
[[nodiscard]] std::string shown(double number);

} // namespace trembler
