// Writes a changed tree as the text that it was read from, except where it differs.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace trembler::edit {

/// A JSON text that people wrote, and the places of all its values. Immutable; thread-safe.
class SourceText {
public:
    /// Keeps the text, which must be valid JSON without repeated keys (JsonDocument::parse() accepts it). An
    /// empty text stands for none.
    explicit SourceText(std::string text);

    [[nodiscard]] std::string const& text() const { return text_; }
    /// The tree of the text; null for an empty one.
    [[nodiscard]] nlohmann::ordered_json const& tree() const { return tree_; }

    /// The text of another tree. Values that the source has, in the same place or in another entry of the
    /// same list, keep their spelling, their line breaks and the blank lines before them; new and changed
    /// ones are laid out as in layOut(). Equal trees give equal texts, and the text of tree() is text().
    /// Reading the result gives the tree. Takes time in proportion to both texts.
    [[nodiscard]] std::string textOf(nlohmann::ordered_json const& tree) const;

private:
    friend class TextMerge;
    struct Node { // a value in the text; its children are entries of a list or an object, in order
        std::size_t begin = 0; // of its bytes
        std::size_t end = 0;
        std::size_t lead = 0; // where the white space before it (or before its key) begins
        std::size_t key = 0;  // where its key begins; begin for entries of lists
        std::vector<Node> children{};
    };
    [[nodiscard]] Node read(std::size_t& at) const;

    std::string text_;
    nlohmann::ordered_json tree_;
    Node root_;
};

} // namespace trembler::edit
