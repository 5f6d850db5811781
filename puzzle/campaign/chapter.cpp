#include "puzzle/campaign/chapter.hpp"

#include "runtime/level/json/json_node.hpp"
#include "runtime/level/json/schema_pieces.hpp"
#include "runtime/level/read/read_texts.hpp"

#include <array>
#include <cctype>
#include <system_error>

namespace trembler {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 2> chapterKinds{"puzzles", "gallery"};
constexpr double mostOrder = 1e6;

} // namespace

bool isNotALevel(fs::path const& file) {
    return file.filename() == chapterFile || file.stem().extension() == ".schema" || file.stem() == "schema";
}

std::string titleFromName(std::string const& name) {
    std::size_t start = 0;
    while (start < name.size() && (std::isdigit(static_cast<unsigned char>(name[start])) != 0)) {
        ++start;
    }
    if (start < name.size() && (name[start] == '-' || name[start] == '_')) {
        ++start;
    } else {
        start = 0; // a number without a separator belongs to the name
    }
    std::string title = name.substr(start);
    for (char& letter : title) {
        letter = letter == '-' || letter == '_' ? ' ' : letter;
    }
    if (!title.empty()) {
        title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
    }
    return title;
}

Chapter readChapter(std::shared_ptr<JsonDocument const> const& document) {
    Problems problems;
    Chapter chapter;
    JsonNode const root(*document, document->root(), "", problems);
    MemberReader reader(root, "a chapter: an object with \"title\", \"text\", \"order\"");
    if (reader.valid()) {
        reader.know("$schema"); // for editors
        if (auto const title = reader.required("title", "the name of the chapter, for people")) {
            chapter.title = title->name("a title").value_or("");
        }
        if (auto const text = reader.optional("text")) {
            chapter.text = text->text().value_or("");
        }
        if (auto const order = reader.optional("order")) {
            chapter.order = order->number(-mostOrder, mostOrder).value_or(chapter.order);
        }
        if (auto const kind = reader.optional("kind")) {
            chapter.kind = static_cast<ChapterKind>(kind->choice(chapterKinds).value_or(0));
        }
        if (auto const texts = reader.optional("texts")) {
            chapter.texts = readTexts(*texts, TextsOf::part);
        }
        reader.finish();
    }
    problems.throwIfAny();
    return chapter;
}

Chapter loadChapter(fs::path const& folder) {
    std::error_code error;
    if (fs::path const file = folder / chapterFile; fs::exists(file, error)) {
        return readChapter(JsonDocument::load(file));
    }
    Chapter chapter;
    chapter.title = titleFromName(folder.filename().string());
    return chapter;
}

nlohmann::ordered_json chapterSchema() {
    using Json = nlohmann::ordered_json;
    Json kinds = Json::array();
    for (std::string_view const kind : chapterKinds) {
        kinds.push_back(kind);
    }
    Json text = json_schema::text();
    text["description"] = "a sentence below the title";
    return Json{
        {"$schema", "https://json-schema.org/draft/2020-12/schema"},
        {"title", "A chapter of Trembler: chapter.json in a folder of levels"},
        {"type", "object"},
        {"required", Json::array({"title"})},
        {"additionalProperties", false},
        {"properties",
         {{"$schema", {{"type", "string"}, {"description", "for editors"}}},
          {"title",
           {{"type", "string"}, {"minLength", 1}, {"maxLength", 100}, {"description", "for people"}}},
          {"text", std::move(text)},
          {"order",
           {{"type", "number"},
            {"minimum", -mostOrder},
            {"maximum", mostOrder},
            {"description", "chapters are sorted by it; left out: after the chapters that state one"}}},
          {"kind",
           {{"enum", std::move(kinds)},
            {"description",
             "puzzles (left out: these) are solved in order; a gallery's levels are demonstrations, kept "
             "apart from them"}}},
          {"texts", textsSchema(TextsOf::part)}}}};
}

} // namespace trembler
