#include "puzzle/language/catalogue.hpp"

#include "runtime/level/json/json_document.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <system_error>

namespace trembler {
namespace {

namespace fs = std::filesystem;

nlohmann::json jsonIn(fs::path const& file) {
    try {
        return nlohmann::json::parse(JsonDocument::readText(file), nullptr, false);
    } catch (InputError const&) { // no texts: what they translate is shown in English
        return nlohmann::json::value_t::discarded;
    }
}

using TextMap = std::map<std::string, std::string, std::less<>>;

/// The files of texts with gaps that translated() recognises.
constexpr std::array<char const*, 4> filesOfMessages{"messages.json", "edits.json", "faults.json",
                                                     "scripts.json"};

/// Whether braces around this are a gap, and not those of a file that a sentence quotes: {"part": name}.
bool isGap(std::string_view inside) {
    constexpr std::array<std::string_view, 4> kinds{"name", "akk", "dat", "own"};
    return inside.empty() || inside.front() == ':' ||
           std::find(kinds.begin(), kinds.end(), inside) != kinds.end();
}

void addTexts(TextMap& texts, fs::path const& file) {
    auto const all = jsonIn(file);
    if (!all.is_object()) {
        return;
    }
    for (auto const& [english, translation] : all.items()) {
        if (translation.is_string()) {
            texts[english] = translation.get<std::string>();
        }
    }
}

/// The contents of the gaps if the text fits.
std::optional<std::vector<std::string>> fitted(std::string_view text,
                                               std::vector<std::string> const& between) {
    std::string const& first = between.front();
    std::string const& last = between.back();
    if (text.size() < first.size() + last.size() || !text.starts_with(first) || !text.ends_with(last)) {
        return std::nullopt;
    }
    std::vector<std::string> arguments;
    std::size_t at = first.size();
    std::size_t const end = text.size() - last.size();
    for (std::size_t i = 1; i + 1 < between.size(); ++i) {
        std::size_t const next = text.find(between[i], at);
        if (next == std::string_view::npos || next + between[i].size() > end) {
            return std::nullopt;
        }
        arguments.emplace_back(text.substr(at, next - at));
        at = next + between[i].size();
    }
    arguments.emplace_back(text.substr(at, end - at));
    return arguments;
}

/// The length of "wind.lua:12: ", a place before a message; 0 if there is none.
std::size_t placeIn(std::string_view text) {
    std::size_t const end = text.find(": ");
    if (end == std::string_view::npos) {
        return 0;
    }
    std::size_t const colon = text.substr(0, end).rfind(':');
    std::string_view const line =
        colon == std::string_view::npos ? std::string_view() : text.substr(colon + 1, end - colon - 1);
    bool const isLine = !line.empty() && line.find_first_not_of("0123456789") == std::string_view::npos;
    return isLine ? end + 2 : 0;
}

} // namespace

Catalogue::Pieces Catalogue::piecesOf(std::string_view text) {
    Pieces pieces;
    std::string piece;
    for (std::size_t i = 0; i < text.size(); ++i) {
        bool const twice = i + 1 < text.size() && text[i + 1] == text[i];
        if ((text[i] == '{' || text[i] == '}') && twice) {
            piece += text[i++];
        } else if (std::size_t const end = text[i] == '{' ? text.find('}', i) : std::string_view::npos;
                   end != std::string_view::npos && isGap(text.substr(i + 1, end - i - 1))) {
            pieces.between.push_back(std::move(piece));
            piece.clear();
            pieces.gaps.emplace_back(text.substr(i + 1, end - i - 1));
            i = end;
        } else {
            piece += text[i];
        }
    }
    pieces.between.push_back(std::move(piece));
    return pieces;
}

Catalogue::Catalogue(fs::path const& folder, std::string_view language) {
    addTexts(texts_, folder / (std::string(language) + ".json"));
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder / language, error), end; !error && entry != end;
         entry.increment(error)) {
        files.push_back(entry->path());
    }
    std::sort(files.begin(), files.end());
    for (fs::path const& file : files) {
        if (file.filename() == "names.json") {
            names_ = GermanNames(jsonIn(file));
        } else if (file.extension() == ".json") {
            addTexts(texts_, file);
        }
    }
    TextMap sentences;
    for (char const* const file : filesOfMessages) {
        addTexts(sentences, folder / language / file);
    }
    for (auto const& [english, translation] : sentences) {
        Pieces pieces = piecesOf(english);
        std::size_t length = 0;
        for (std::string const& piece : pieces.between) {
            length += piece.size();
        }
        if (!pieces.gaps.empty() && length > 0) {
            templates_.push_back({std::move(pieces), length, translation});
        }
    }
    std::stable_sort(templates_.begin(), templates_.end(),
                     [](Template const& a, Template const& b) { return a.length > b.length; });
}

char const* Catalogue::find(std::string_view english) const {
    auto const found = texts_.find(english);
    return found == texts_.end() ? nullptr : found->second.c_str();
}

std::string Catalogue::translated(std::string const& english) const {
    if (char const* const known = find(english)) {
        return known;
    }
    constexpr std::size_t longest = 2000; // no sentence of ours; a traceback may be
    if (english.size() > longest) {
        return english;
    }
    if (std::size_t const place = placeIn(english); place > 0) {
        return english.substr(0, place) + translated(english.substr(place));
    }
    for (Template const& one : templates_) {
        if (auto const arguments = fitted(english, one.english.between)) {
            return filled(one, *arguments);
        }
    }
    return english;
}

std::string Catalogue::translatedInside(std::string const& argument) const {
    if (!argument.empty() && argument.front() >= 'a' && argument.front() <= 'z' &&
        find(argument) == nullptr) {
        std::string title = argument; // "mass" of the property "Mass"
        title.front() = static_cast<char>(title.front() - 'a' + 'A');
        if (char const* const known = find(title)) {
            return known;
        }
    }
    return translated(argument);
}

std::string Catalogue::filled(Template const& found, std::vector<std::string> const& arguments) const {
    Pieces const pieces = piecesOf(found.translation);
    std::string text = pieces.between.front();
    for (std::size_t i = 0; i < pieces.gaps.size(); ++i) {
        std::string const& gap = pieces.gaps[i];
        std::string const& argument = arguments[std::min(i, arguments.size() - 1)];
        if (gap == "own") {
            text += argument;
        } else if (gap == "name") {
            text += names_.bare(argument);
        } else if (gap == "akk" || gap == "dat") {
            text += names_.definite(argument, gap == "akk" ? GermanCase::accusative : GermanCase::dative);
        } else {
            text += argument.size() < found.length + 200 ? translatedInside(argument) : argument;
        }
        text += pieces.between[i + 1];
    }
    return text;
}

} // namespace trembler
