#include "runtime/level/read/read_texts.hpp"

#include "runtime/level/json/limits.hpp"
#include "runtime/level/json/schema_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {
namespace {

bool isLanguage(std::string const& key) {
    return key.size() == 2 &&
           std::all_of(key.begin(), key.end(), [](char c) { return c >= 'a' && c <= 'z'; });
}

Translation readTranslation(JsonNode const& node, TextsOf of) {
    Translation texts;
    MemberReader reader(node, "an object with \"title\", \"text\"");
    if (auto const title = reader.optional("title")) {
        texts.title = title->name("a title").value_or("");
    }
    if (auto const text = reader.optional("text")) {
        texts.text = text->text().value_or("");
    }
    if (of == TextsOf::level) {
        if (auto const hints = reader.optional("hints");
            hints && hints->isList("a list of texts", limits::hints)) {
            for (std::size_t i = 0; i < hints->size(); ++i) {
                texts.hints.push_back(hints->element(i).text().value_or(""));
            }
        }
        if (auto const goals = reader.optional("goals");
            goals && goals->isObject("texts by the ids of goals")) {
            for (auto const& [id, value] : goals->value().items()) {
                texts.goals[id] = goals->member(id).text().value_or("");
            }
        }
    }
    reader.finish();
    return texts;
}

} // namespace

Translations readTexts(JsonNode const& node, TextsOf of) {
    Translations all;
    if (!node.isObject("an object of languages, like {\"de\": {\"title\": \"...\"}}")) {
        return all;
    }
    for (auto const& [language, value] : node.value().items()) {
        if (isLanguage(language)) {
            all[language] = readTranslation(node.member(language), of);
        } else {
            node.complainAboutKey(language, fmt::format("'{}' is no language", language),
                                  "two small letters, like \"de\"");
        }
    }
    return all;
}

nlohmann::ordered_json writeTexts(Translations const& texts) {
    nlohmann::ordered_json all = nlohmann::ordered_json::object();
    for (auto const& [language, one] : texts) {
        nlohmann::ordered_json out = nlohmann::ordered_json::object();
        if (!one.title.empty()) {
            out["title"] = one.title;
        }
        if (!one.text.empty()) {
            out["text"] = one.text;
        }
        if (!one.hints.empty()) {
            out["hints"] = one.hints;
        }
        if (!one.goals.empty()) {
            out["goals"] = one.goals;
        }
        all[language] = std::move(out);
    }
    return all;
}

nlohmann::ordered_json textsSchema(TextsOf of) {
    using Json = nlohmann::ordered_json;
    Json const text = json_schema::text();
    Json members{{"title", {{"type", "string"}, {"minLength", 1}, {"maxLength", 100}}}, {"text", text}};
    if (of == TextsOf::level) {
        members["hints"] = json_schema::listOf(text, limits::hints);
        members["goals"] = Json{{"type", "object"},
                                {"additionalProperties", text},
                                {"description", "Texts of goals by their ids."}};
    }
    return Json{{"type", "object"},
                {"description", "What it says in other languages; what is left out there stays as it is."},
                {"patternProperties", {{"^[a-z][a-z]$", json_schema::strictObject(std::move(members))}}},
                {"additionalProperties", false}};
}

} // namespace trembler
