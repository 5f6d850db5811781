#include "puzzle/edit/text/source_text.hpp"

#include "puzzle/edit/text/text_merge.hpp"

#include <utility>

namespace trembler::edit {
namespace {

bool isSpace(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

void skipSpaceIn(std::string const& text, std::size_t& at) {
    while (at < text.size() && isSpace(text[at])) {
        ++at;
    }
}

void skipStringIn(std::string const& text, std::size_t& at) {
    for (++at; at < text.size() && text[at] != '"'; ++at) {
        at += text[at] == '\\' ? 1U : 0U;
    }
    ++at;
}

} // namespace

SourceText::SourceText(std::string text) : text_(std::move(text)) {
    if (text_.empty()) {
        return;
    }
    tree_ = nlohmann::ordered_json::parse(text_);
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    std::size_t at = text_.starts_with(byteOrderMark) ? byteOrderMark.size() : 0;
    skipSpaceIn(text_, at);
    root_ = read(at);
}

// The text is valid, so only the characters needed to find the ends of values are examined.
SourceText::Node SourceText::read(std::size_t& at) const {
    Node node;
    node.begin = node.key = node.lead = at;
    char const open = text_[at];
    if (open == '"') {
        skipStringIn(text_, at);
    } else if (open != '{' && open != '[') {
        while (at < text_.size() && !isSpace(text_[at]) && text_[at] != ',' && text_[at] != '}' &&
               text_[at] != ']') {
            ++at;
        }
    } else {
        ++at;
        for (;;) {
            std::size_t const lead = at;
            skipSpaceIn(text_, at);
            if (text_[at] == '}' || text_[at] == ']') {
                break;
            }
            std::size_t const key = at;
            if (open == '{') {
                skipStringIn(text_, at);
                skipSpaceIn(text_, at);
                ++at; // the colon
                skipSpaceIn(text_, at);
            }
            Node child = read(at);
            child.lead = lead;
            child.key = key;
            node.children.push_back(std::move(child));
            skipSpaceIn(text_, at);
            if (text_[at] == ',') {
                ++at;
            }
        }
        ++at;
    }
    node.end = at;
    return node;
}

std::string SourceText::textOf(nlohmann::ordered_json const& tree) const {
    return TextMerge(*this).textOf(tree);
}

} // namespace trembler::edit
