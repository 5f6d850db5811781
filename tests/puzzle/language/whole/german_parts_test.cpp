// A part has one German name: in the toolbox, in names.json, from which sentences and panels take it, and in
// the hints of the levels.
#include "puzzle/data/game_data.hpp"
#include "puzzle/language/catalogue.hpp"
#include "puzzle/language/german_names.hpp"
#include "runtime/level/read/read_level.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace trembler {
namespace {

namespace fs = std::filesystem;

/// The text in small letters, except "Ä", "Ö" and "Ü", with which no name here begins.
std::string withoutCapitals(std::string text) {
    for (char& c : text) {
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return text;
}

struct ToolboxWords {
    GameData data;
    GermanNames names = Catalogue(fs::path(TREMBLER_SOURCE_DIR) / "assets/text", "de").names();

    [[nodiscard]] std::string titleOf(std::string const& part) const {
        PartDefinition const& definition = *data.parts.find(part);
        return withoutCapitals(titleIn(definition.texts, "de", definition.title));
    }
    /// The noun of names.json, in all forms that a sentence may have.
    [[nodiscard]] std::set<std::string> formsOf(std::string const& part) const {
        std::set<std::string> forms;
        for (auto const use : {GermanCase::nominative, GermanCase::accusative, GermanCase::dative}) {
            for (std::string const& said : {names.definite(part, use), names.plural(part, use)}) {
                forms.insert(withoutCapitals(said.substr(said.rfind(' ') + 1)));
            }
        }
        return forms;
    }
};

ToolboxWords const& toolboxWords() {
    static ToolboxWords const words;
    return words;
}

TEST(GermanParts, AreCalledInTheToolboxAsInSentences) {
    for (std::string const& part : toolboxWords().data.parts.names()) {
        std::string const title = toolboxWords().titleOf(part);
        ASSERT_TRUE(toolboxWords().names.understands(part)) << part;
        // "kleiner Magnet": each word; a title may say more, as "Seil mit Haken" and "Metallzahnrad" do.
        std::istringstream name(withoutCapitals(toolboxWords().names.bare(part)));
        for (std::string word; name >> word;) {
            EXPECT_NE(title.find(word), std::string::npos)
                << part << " is \"" << title << "\" in the toolbox, and \"" << toolboxWords().names.bare(part)
                << "\" in sentences";
        }
    }
}

/// Where the text names the part, in the singular or the plural, as words of their own.
std::size_t namedAt(std::string const& text, std::string const& part) {
    auto const isLetter = [&](std::size_t at) {
        return at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0;
    };
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        std::size_t end = at + part.size();
        end += end < text.size() && text[end] == 's' ? 1 : 0;
        if ((at == 0 || !isLetter(at - 1)) && !isLetter(end)) {
            return at;
        }
    }
    return std::string::npos;
}

TEST(GermanParts, AreCalledInHintsAsInTheToolbox) {
    /// The connection between two objects is "Leitung" in German; in English both are wires.
    std::set<std::pair<std::string, std::string>> const otherThings = {
        {"1-both-gaps.json", "Follow the wire from the yellow flash to the lamp: it ends at a piece of "
                             "copper, twice."}};
    int compared = 0;
    for (auto const& entry : fs::recursive_directory_iterator(fs::path(TREMBLER_SOURCE_DIR) / "levels")) {
        std::string const file = entry.path().filename().string();
        if (file.empty() || std::isdigit(static_cast<unsigned char>(file[0])) == 0 || entry.is_directory()) {
            continue;
        }
        LevelFile const level = loadLevel(toolboxWords().data.registry, entry.path());
        ASSERT_TRUE(level.texts.contains("de")) << file;
        std::vector<std::string> const& german = level.texts.at("de").hints;
        ASSERT_EQ(german.size(), level.hints.size()) << file;
        std::vector<std::string> parts;
        for (ToolboxEntry const& tool : level.toolbox) {
            parts.push_back(tool.part);
        }
        std::sort(parts.begin(), parts.end(), [](std::string const& a, std::string const& b) {
            return a.size() > b.size(); // a short wire is no wire
        });
        for (std::size_t i = 0; i < german.size(); ++i) {
            std::string english = withoutCapitals(level.hints[i]);
            for (std::string const& part : parts) {
                std::size_t const at = namedAt(english, part);
                if (at == std::string::npos || otherThings.contains({file, level.hints[i]})) {
                    continue;
                }
                english.replace(at, part.size(), "#");
                ++compared;
                std::string const hint = withoutCapitals(german[i]);
                std::set<std::string> const forms = toolboxWords().formsOf(part);
                EXPECT_TRUE(std::any_of(
                    forms.begin(), forms.end(),
                    [&](std::string const& form) { return hint.find(form) != std::string::npos; }))
                    << file << " does not call the " << part << " \"" << *forms.begin()
                    << "\": " << german[i];
            }
        }
    }
    EXPECT_GT(compared, 60) << "hints name parts";
}

/// Adds the names that goals give to their areas.
void addCalled(nlohmann::json const& goals, std::set<std::string>& called) {
    if (goals.is_object() && goals.contains("called")) {
        called.insert(goals["called"].get<std::string>());
    }
    if (goals.is_structured()) {
        for (nlohmann::json const& inner : goals) {
            addCalled(inner, called);
        }
    }
}

TEST(GermanParts, AndTheAreasOfGoalsHaveNames) {
    std::set<std::string> called;
    for (fs::path const& file : toolboxWords().data.levels()) {
        LevelFile const level = loadLevel(toolboxWords().data.registry, file);
        addCalled(level.goals, called);
        addCalled(level.task, called);
    }
    EXPECT_GT(called.size(), 5U);
    std::string const article = "the ";
    for (std::string const& area : called) {
        ASSERT_TRUE(area.starts_with(article)) << area;
        EXPECT_TRUE(toolboxWords().names.understands(area.substr(article.size()))) << area;
    }
}

} // namespace
} // namespace trembler
