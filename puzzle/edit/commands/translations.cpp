#include "puzzle/edit/commands/translations.hpp"

#include "puzzle/edit/tree/tree_access.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

namespace trembler::edit {
namespace {

constexpr char const* textsKey = "texts";

Json const& memberIn(Json const& object, char const* key) {
    static Json const none;
    auto const found = object.is_object() ? object.find(key) : object.end();
    return found == object.end() ? none : *found;
}

Json const& translationIn(Json const& level, std::string const& language) {
    return memberIn(memberIn(level, textsKey), language.c_str());
}

void mustHaveLanguage(Json const& level, std::string const& language) {
    if (!translationIn(level, language).is_object()) {
        throw CommandError(fmt::format("the level has no texts in the language '{}'", language));
    }
}

void setInTranslation(Json& level, std::string const& language, std::string const& key, Json value) {
    mustHaveLanguage(level, language);
    static std::vector<std::string> const order{"title", "text", "hints", "goals"};
    Json& texts = level[textsKey][language];
    if (value.empty()) { // null, or an empty list or object
        texts.erase(key);
    } else {
        setMember(texts, key, std::move(value), order);
    }
}

Json textOrNone(std::string const& text) {
    return text.empty() ? Json() : Json(text);
}

std::string textIn(Json const& list, std::size_t index) {
    return list.is_array() && index < list.size() && list[index].is_string() ? list[index].get<std::string>()
                                                                             : std::string();
}

/// The texts of conditions, inner ones included, that have an id or state a text.
void addGoals(Json const& condition, std::vector<TranslatedText>& all, std::set<std::string>& ids) {
    if (condition.is_object()) {
        TranslatedText goal;
        goal.of = TranslatedText::Of::goal;
        goal.id = textOf(condition, "id");
        goal.original = textOf(condition, "text");
        bool const fresh = goal.id.empty() ? !goal.original.empty() : ids.insert(goal.id).second;
        if (fresh) {
            all.push_back(std::move(goal));
        }
    }
    if (condition.is_structured()) {
        for (Json const& child : condition) {
            addGoals(child, all, ids);
        }
    }
}

/// Whether a condition, or one inside it, has the id.
bool hasId(Json const& condition, std::string const& id) {
    return textOf(condition, "id") == id ||
           (condition.is_structured() && std::any_of(condition.begin(), condition.end(),
                                                     [&](Json const& child) { return hasId(child, id); }));
}

/// Every translation that is an object.
void forTranslations(Json& level, std::function<void(Json&)> const& change) {
    auto const texts = level.is_object() ? level.find(textsKey) : level.end();
    if (texts == level.end() || !texts->is_object()) {
        return;
    }
    for (auto const& item : texts->items()) {
        if (item.value().is_object()) {
            change(item.value());
        }
    }
}

void forTranslatedHints(Json& level, std::function<void(Json&)> const& change) {
    forTranslations(level, [&](Json& translation) {
        auto const hints = translation.find("hints");
        if (hints == translation.end() || !hints->is_array()) {
            return;
        }
        change(*hints);
        if (hints->empty()) {
            translation.erase("hints");
        }
    });
}

} // namespace

std::vector<std::string> languagesOf(Json const& level) {
    std::vector<std::string> languages;
    if (Json const& texts = memberIn(level, textsKey); texts.is_object()) {
        for (auto const& item : texts.items()) {
            languages.push_back(item.key());
        }
    }
    return languages;
}

std::vector<TranslatedText> translatedTexts(Json const& level, std::string const& language) {
    using Of = TranslatedText::Of;
    Json const& there = translationIn(level, language);
    std::vector<TranslatedText> all;
    for (auto const& [of, key] : {std::pair{Of::title, "title"}, std::pair{Of::text, "text"}}) {
        TranslatedText text;
        text.of = of;
        text.original = textOf(level, key);
        text.translation = textOf(there, key);
        text.missing = !text.original.empty() && text.translation.empty();
        all.push_back(std::move(text));
    }
    Json const& hints = memberIn(level, "hints");
    for (std::size_t i = 0; hints.is_array() && i < hints.size(); ++i) {
        TranslatedText hint;
        hint.of = Of::hint;
        hint.index = i;
        hint.original = textIn(hints, i);
        hint.translation = textIn(memberIn(there, "hints"), i);
        if (hint.translation == hint.original) { // it only keeps the place of a translation
            hint.translation.clear();
        }
        hint.missing = !hint.original.empty() && hint.translation.empty();
        all.push_back(std::move(hint));
    }
    std::set<std::string> ids;
    std::size_t const firstGoal = all.size();
    addGoals(memberIn(level, "goals"), all, ids);
    addGoals(memberIn(level, "task"), all, ids);
    Json const& goals = memberIn(there, "goals");
    for (std::size_t i = firstGoal; i < all.size(); ++i) {
        all[i].translation = all[i].id.empty() ? "" : textOf(goals, all[i].id.c_str());
        all[i].missing = !all[i].original.empty() && all[i].translation.empty();
    }
    for (auto const& item : goals.items()) {
        if (goals.is_object() && !ids.contains(item.key())) {
            TranslatedText lost;
            lost.of = Of::goal;
            lost.id = item.key();
            lost.translation = textOf(goals, item.key().c_str());
            lost.lost = true;
            all.push_back(std::move(lost));
        }
    }
    return all;
}

Command addLanguage(Json const& level, std::string const& language) {
    bool const valid = language.size() == 2 && std::all_of(language.begin(), language.end(),
                                                           [](char c) { return c >= 'a' && c <= 'z'; });
    if (!valid) {
        throw CommandError(
            fmt::format("'{}' is no language; languages are two small letters, like 'de'", language));
    }
    if (translationIn(level, language).is_object()) {
        throw CommandError(fmt::format("the level has texts in the language '{}' already", language));
    }
    return {fmt::format("Add language {}", language),
            [language](Json& tree) { objectIn(tree, textsKey)[language] = Json::object(); }};
}

Command removeLanguage(Json const& level, std::string const& language) {
    mustHaveLanguage(level, language);
    return {fmt::format("Remove language {}", language), [language](Json& tree) {
                mustHaveLanguage(tree, language);
                tree[textsKey].erase(language);
                dropIfEmpty(tree, textsKey);
            }};
}

Command translateTitle(Json const& level, std::string const& language, std::string const& title) {
    mustHaveLanguage(level, language);
    if (!title.empty()) {
        mustBeName(title, "the title");
    }
    return {"Translate title",
            [language, title](Json& tree) { setInTranslation(tree, language, "title", textOrNone(title)); }};
}

Command translateText(Json const& level, std::string const& language, std::string const& text) {
    mustHaveLanguage(level, language);
    return {"Translate text",
            [language, text](Json& tree) { setInTranslation(tree, language, "text", textOrNone(text)); }};
}

Command translateHint(Json const& level, std::string const& language, std::size_t index,
                      std::string const& hint) {
    mustHaveLanguage(level, language);
    mustHaveEntry(level, "hints", index, "hint");
    return {"Translate hint", [language, index, hint](Json& tree) {
                mustHaveLanguage(tree, language);
                mustHaveEntry(tree, "hints", index, "hint");
                Json const& own = tree["hints"];
                Json hints = memberIn(translationIn(tree, language), "hints");
                if (!hints.is_array()) {
                    hints = Json::array();
                }
                while (hints.size() < own.size()) {
                    hints.push_back(own[hints.size()]);
                }
                hints[index] = hint.empty() ? own[index] : Json(hint);
                setInTranslation(tree, language, "hints", hints == own ? Json() : std::move(hints));
            }};
}

Command translateGoal(Json const& level, std::string const& language, std::string const& id,
                      std::string const& text) {
    mustHaveLanguage(level, language);
    mustBeName(id, "the id of a goal");
    return {"Translate goal", [language, id, text](Json& tree) {
                mustHaveLanguage(tree, language);
                Json goals = memberIn(translationIn(tree, language), "goals");
                if (!goals.is_object()) {
                    goals = Json::object();
                }
                if (text.empty()) {
                    goals.erase(id);
                } else {
                    goals[id] = text;
                }
                setInTranslation(tree, language, "goals", std::move(goals));
            }};
}

void translationsChangedHint(Json& level, std::size_t index, Json const& before, std::string const& hint) {
    Json const stated = before; // it may lie in the level
    forTranslatedHints(level, [&](Json& hints) {
        if (index < hints.size() && hints[index] == stated) {
            hints[index] = hint;
        }
    });
}

void translationsGotHint(Json& level, std::string const& hint) {
    Json const& own = memberIn(level, "hints");
    std::size_t const count = own.is_array() ? own.size() : 0;
    forTranslatedHints(level, [&](Json& hints) {
        if (hints.size() + 1 == count) {
            hints.push_back(hint);
        }
    });
}

void translationsLostHint(Json& level, std::size_t index) {
    forTranslatedHints(level, [&](Json& hints) {
        if (index < hints.size()) {
            hints.erase(index);
        }
    });
}

void translationsMovedHint(Json& level, std::size_t from, std::size_t to) {
    forTranslatedHints(level, [&](Json& hints) {
        if (from < hints.size() && to < hints.size()) {
            Json const moved = hints[from];
            hints.erase(from);
            auto& list = hints.get_ref<Json::array_t&>();
            list.insert(list.begin() + static_cast<std::ptrdiff_t>(to), moved);
        }
    });
}

void translationsRenamedGoal(Json& level, std::string const& from, std::string const& to) {
    bool const shared = hasId(memberIn(level, "goals"), from) || hasId(memberIn(level, "task"), from);
    forTranslations(level, [&](Json& translation) {
        auto const goals = translation.find("goals");
        if (goals == translation.end() || !goals->is_object() || !goals->contains(from) ||
            goals->contains(to)) {
            return;
        }
        Json renamed = Json::object();
        for (auto const& item : goals->items()) {
            if (item.key() != from || shared) {
                renamed[item.key()] = item.value();
            }
            if (item.key() == from) {
                renamed[to] = item.value();
            }
        }
        *goals = std::move(renamed);
    });
}

} // namespace trembler::edit
