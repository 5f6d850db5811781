// Joins the text of a source with the values that differ from it. Used by SourceText only.
#pragma once

#include "puzzle/edit/text/source_text.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace trembler::edit {

class TextMerge {
public:
    explicit TextMerge(SourceText const& source) : source_(source) {}
    /// To be called once.
    [[nodiscard]] std::string textOf(nlohmann::ordered_json const& tree);

private:
    using Tree = nlohmann::ordered_json;
    using Node = SourceText::Node;

    void write(Tree const& value, Tree const& old, Node const& node);
    void writeMembers(Tree const& value, Tree const& old, Node const& node);
    void writeEntries(Tree const& value, Tree const& old, Node const& node);
    void writeNew(Tree const& value);
    /// The white space before an entry that the source has, or, with nullptr, has not.
    void writeLead(Node const& around, Node const* entry, bool first);
    void add(std::string_view text);
    /// Lays out a container again that was one line in the source and has become too wide for one.
    void narrow(Tree const& value, Node const& node, std::size_t begin, std::size_t indent,
                std::size_t column);
    [[nodiscard]] std::string_view of(std::size_t begin, std::size_t end) const;
    [[nodiscard]] std::size_t column() const { return out_.size() - lineStart_; }
    [[nodiscard]] std::size_t indent() const;

    SourceText const& source_;
    std::string out_;
    std::size_t lineStart_ = 0; // in out_
    std::string_view lastLead_; // of the last entry but the first, in the container that is being written
};

/// For every entry of a list the entry of an older list whose text it takes over, or `none`: an equal one,
/// else one of the same name, else, in lists of one length, the one in its place.
inline constexpr std::size_t noEntry = static_cast<std::size_t>(-1);
[[nodiscard]] std::vector<std::size_t> matchedEntries(nlohmann::ordered_json const& now,
                                                      nlohmann::ordered_json const& old);

} // namespace trembler::edit
