#include "lua/reference/page.hpp"
#include "puzzle/data/effects.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace trembler::lua {
namespace {

struct Printed {
    Printed() {
        registerEffects(registry);
        reference = makeReference(registry);
    }
    Registry registry;
    Reference reference;
};

TEST(ReferencePage, HasAHeadingAndAnExampleForEach) {
    Printed const made;
    std::string const page = referenceMarkdown(made.reference);
    for (ReferenceFunction const& function : made.reference.functions) {
        EXPECT_NE(page.find("### " + std::string(function.call->text.name) + "\n"), std::string::npos);
        EXPECT_NE(page.find("```lua\n" + function.example + "```"), std::string::npos);
    }
    for (ReferenceProperty const& property : made.reference.properties) {
        EXPECT_NE(page.find("### " + std::string(property.info->text.name) + "\n"), std::string::npos);
        EXPECT_NE(page.find("```lua\n" + property.body + "```"), std::string::npos);
    }
    EXPECT_NE(page.find("| `force` | vec2 | N | -1e+12 to 1e+12 |  | force at the centre of mass |"),
              std::string::npos);
}

TEST(ReferencePage, HasTablesWhoseRowsHaveAsManyCells) {
    Printed const made;
    std::string const page = referenceMarkdown(made.reference);
    std::ptrdiff_t cells = 0;
    std::size_t begin = 0;
    while (begin < page.size()) {
        std::size_t const end = page.find('\n', begin);
        std::string line = page.substr(begin, end - begin);
        begin = end + 1;
        for (std::size_t at = 0; (at = line.find("\\|")) != std::string::npos;) {
            line.erase(at, 2);
        }
        if (!line.starts_with('|')) {
            cells = 0;
            continue;
        }
        std::ptrdiff_t const here = std::count(line.begin(), line.end(), '|');
        EXPECT_TRUE(cells == 0 || cells == here) << line;
        cells = here;
    }
}

TEST(ReferenceJson, IsWhatThePageSays) {
    Printed const made;
    auto const json = nlohmann::json::parse(referenceJson(made.reference).dump());
    EXPECT_EQ(json["functions"].size(), made.reference.functions.size());
    EXPECT_EQ(json["properties"].size(), made.reference.properties.size());
    EXPECT_EQ(json["functions"][0]["resolver"], made.reference.functions[0].role->name);
    for (auto const& property : json["properties"]) {
        EXPECT_FALSE(property["example"].get<std::string>().empty());
        EXPECT_FALSE(property["meaning"].get<std::string>().empty());
    }
}

} // namespace
} // namespace trembler::lua
