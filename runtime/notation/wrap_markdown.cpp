#include "runtime/notation/wrap_markdown.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace trembler {
namespace {

std::size_t charactersIn(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
        return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; // not a continuation of a character
    }));
}

/// Whether a line that begins with this word would be something else than prose.
bool beginsAnotherBlock(std::string_view word) {
    bool const numbered = word.size() > 1 && (word.back() == '.' || word.back() == ')') &&
                          std::all_of(word.begin(), word.end() - 1, [](char c) {
                              return std::isdigit(static_cast<unsigned char>(c)) != 0;
                          });
    return numbered || word == "-" || word == "+" || word == "*" || word.starts_with("#") ||
           word.starts_with(">") || word.starts_with("|") || word.starts_with("```");
}

/// Split at spaces, except between backquotes.
std::vector<std::string_view> wordsOf(std::string_view text) {
    std::vector<std::string_view> words;
    std::size_t begin = 0;
    bool code = false;
    for (std::size_t at = 0; at <= text.size(); ++at) {
        code = code != (at < text.size() && text[at] == '`');
        if (at == text.size() || (text[at] == ' ' && !code)) {
            if (at > begin) {
                words.push_back(text.substr(begin, at - begin));
            }
            begin = at + 1;
        }
    }
    return words;
}

/// How many characters at the beginning of a line its continuation is indented by: spaces, and an entry's
/// mark.
std::size_t indentOf(std::string_view line) {
    std::size_t const first = std::min(line.find_first_not_of(' '), line.size());
    std::size_t const space = line.find(' ', first);
    if (space == std::string_view::npos || line[first] == '>' || line[first] == '#' ||
        !beginsAnotherBlock(line.substr(first, space - first))) {
        return first;
    }
    return std::min(line.find_first_not_of(' ', space), line.size());
}

bool isProse(std::string_view line) {
    std::size_t const first = line.find_first_not_of(' ');
    return first != std::string_view::npos && first < 4 && line[first] != '|' && line[first] != '#' &&
           line[first] != '>' && line[first] != '<' && !line.substr(first).starts_with("![");
}

void wrapLine(std::string_view line, std::size_t width, std::string& out) {
    std::size_t const indent = indentOf(line);
    out += line.substr(0, indent);
    std::size_t length = indent;
    bool first = true;
    for (std::string_view const word : wordsOf(line.substr(indent))) {
        std::size_t const added = charactersIn(word);
        if (!first && length + 1 + added > width && !beginsAnotherBlock(word)) {
            out += '\n' + std::string(indent, ' ');
            length = indent;
        } else if (!first) {
            out += ' ';
            ++length;
        }
        out += word;
        length += added;
        first = false;
    }
}

} // namespace

std::string wrapMarkdown(std::string_view page, std::size_t width) {
    std::string out;
    bool code = false;
    for (std::size_t begin = 0; begin < page.size();) {
        std::size_t const end = std::min(page.find('\n', begin), page.size());
        std::string_view const line = page.substr(begin, end - begin);
        bool const fence = line.starts_with("```");
        code = code != fence;
        if (!code && !fence && isProse(line) && charactersIn(line) > width) {
            wrapLine(line, width, out);
        } else {
            out += line;
        }
        if (end < page.size()) {
            out += '\n';
        }
        begin = end + 1;
    }
    return out;
}

} // namespace trembler
