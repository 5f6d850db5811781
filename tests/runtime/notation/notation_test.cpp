// The notation compared with the thesis's own boxes (6.13): it prints the declarations of the types.
#include "runtime/notation/notation.hpp"
#include "tests/runtime/schedule/apportionment.hpp"
#include "tests/runtime/world/heat.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace trembler {
namespace {

struct Kit {
    Registry registry;
    Kit() { apportionment::registerApportionment(registry); }
    [[nodiscard]] Registration const& named(std::string_view wanted) const {
        return *std::find_if(registry.components().begin(), registry.components().end(),
                             [&](Registration const& r) { return title(*r.info) == wanted; });
    }
    [[nodiscard]] std::string box(std::string_view wanted) const {
        return notationBox(registry, named(wanted));
    }
};

// The text under a label of a box, without line breaks.
std::string under(std::string const& box, std::string const& label) {
    std::istringstream lines(box);
    std::string text;
    bool inside = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind(label + ":", 0) == 0) {
            inside = true;
            line.erase(0, label.size() + 1);
        } else if (inside && line[0] != ' ') {
            break;
        }
        if (inside) {
            std::size_t const start = line.find_first_not_of(' ');
            text += (text.empty() ? "" : " ") + (start == std::string::npos ? "" : line.substr(start));
        }
    }
    return text;
}

TEST(Notation, PrintsTheDynamicsResolverAsTheThesisDoes) {
    std::string const box = Kit().box("Dynamics Resolver");
    EXPECT_EQ(under(box, "Properties read"),
              "{Position, Velocity, Angular Velocity, Rotation, Shape, Mass, Liquid}");
    EXPECT_EQ(under(box, "Properties written"), "{Position, Velocity, Angular Velocity, Rotation}");
    EXPECT_EQ(under(box, "Resolver properties"), "{C_C, C_N, C_P}");
    EXPECT_NE(under(box, "Work on advance()").find("both collision detection and rigid body simulation"),
              std::string::npos);
    EXPECT_NE(box.find("addForceToPoint(object, point, force) - Adds the specified force to the object"),
              std::string::npos)
        << box;
    EXPECT_NE(box.find("[sum, held]"), std::string::npos) << "every call states its algebra";
}

TEST(Notation, PrintsEmptySetsDerivedPropertiesAndCalls) {
    Kit const kit;
    EXPECT_EQ(under(kit.box("Magnetics Resolver"), "Resolver properties"), "∅");
    EXPECT_EQ(under(kit.box("Linear Gravity DPS"), "Properties read"), "∅");
    EXPECT_EQ(under(kit.box("Magnetics Resolver"), "Properties read"), "{Magnet on/off}")
        << "a resolver may also read the properties that it writes; the thesis has ∅ here";
    EXPECT_EQ(under(kit.box("Linear Gravity DPS"), "Derived properties"), "{F_G}");
    EXPECT_EQ(under(kit.box("Real Gravity DPS"), "Derived properties"), "{F_G}")
        << "exactly the same set (6.13.3)";
    EXPECT_EQ(under(kit.box("Real Gravity DPS"), "Properties read"), "{Position, Mass}");
    EXPECT_EQ(under(kit.box("Real Gravity DPS"), "Detail level"), "gravity = real");
    std::string const box = kit.box("(Dynamics <- Gravity) Interaction");
    EXPECT_EQ(under(box, "Properties read"), "{Position, F_G}");
    EXPECT_EQ(under(box, "Calls"), "Dynamics Resolver");
    EXPECT_EQ(under(kit.box("Buoyancy Resolver"), "Activated by"), "objects with all of {Liquid}");
    EXPECT_EQ(under(kit.box("Magnetics Resolver"), "Activated by"), "objects with any of {Magnetic poles}");
}

TEST(Notation, MarksEqualReadAndWriteSets) {
    Kit const kit;
    EXPECT_EQ(under(kit.box("Electricity Resolver"), "Properties read"), "{G_E}");
    EXPECT_EQ(under(kit.box("Electricity Resolver"), "Properties written"), "≡ read(Electricity Resolver)")
        << "as in 6.13.2";
    EXPECT_EQ(under(kit.box("Buoyancy Resolver"), "Properties written"), "∅");
}

TEST(Notation, WrittenPropertiesAreAmongTheReadOnes) {
    Registry registry;
    registry.component<heat::Stove>(); // reads only the properties that it writes
    EXPECT_EQ(under(notationBox(registry, registry.components()[0]), "Properties read"), "{Heat}");
    EXPECT_EQ(under(notationBox(registry, registry.components()[0]), "Properties written"),
              "≡ read(Stove Resolver)");
    nlohmann::json const all = nlohmann::json::parse(notationJson(registry).dump());
    EXPECT_EQ(all["components"][0]["reads"], nlohmann::json{"Heat"});
}

TEST(Notation, PrintsPropertyBoxes) {
    Kit const kit;
    std::string const box = notationBox(propertyInfo<Position>());
    EXPECT_NE(box.find("\nPosition Property\n"), std::string::npos) << box;
    EXPECT_NE(box.find("\nThe X and Y coordinates of the object.\n"), std::string::npos) << box;
    EXPECT_EQ(under(box, "value"), "vector in m: centre of the object");
    std::string const text = notationText(kit.registry);
    std::string const markdown = notationMarkdown(kit.registry);
    for (PropertyInfo const* property : kit.registry.objectProperties()) {
        std::string const title = std::string(property->text.name) + " Property";
        EXPECT_NE(text.find("\n" + title + "\n"), std::string::npos) << title;
        EXPECT_NE(markdown.find("### " + title + "\n"), std::string::npos) << title;
    }
}

TEST(Notation, PrintsTheCoverageOfTheStateHash) {
    Kit const kit;
    std::string const text = notationText(kit.registry);
    for (char const* line : {"hashed: every member of every object property", "hashed: F_B\n",
                             "derived: F_G (a pure function", "left out: versions"}) {
        EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
    }
    nlohmann::json const all = nlohmann::json::parse(notationJson(kit.registry).dump());
    for (auto const& line : all["state_hash"]) {
        EXPECT_EQ(line["covered"] == "hashed", line["reason"] == "") << line;
    }
}

TEST(Notation, LinesStayWithinTheBox) {
    std::istringstream lines(notationText(Kit().registry));
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LE(line.size(), 130U) << line; // bytes; the few symbols are longer in UTF-8
    }
}

TEST(Notation, PrintsTheSchedule) {
    std::string const text = notationText(Kit().registry);
    EXPECT_NE(text.find("Electricity Resolver in parallel with Magnetics Resolver"), std::string::npos);
    EXPECT_NE(text.find("Dynamics Resolver in parallel with Electricity Resolver"), std::string::npos);
    EXPECT_NE(
        text.find("Dynamics Resolver before Buoyancy Resolver: Position is written, then read, Rotation is "
                  "written, then read"),
        std::string::npos)
        << text.substr(text.find("Schedule of a frame"));
    EXPECT_NE(text.find("all derived property sets, in parallel"), std::string::npos);
    EXPECT_NE(text.find("all interactions, in parallel"), std::string::npos);
}

TEST(Notation, PrintsMarkdownWithABoxForEveryComponent) {
    Kit const kit;
    std::string const text = notationMarkdown(kit.registry);
    for (Registration const& r : kit.registry.components()) {
        EXPECT_NE(text.find("### " + title(*r.info) + "\n"), std::string::npos);
    }
    EXPECT_NE(text.find("## Schedule of a frame"), std::string::npos);
}

TEST(Notation, PrintsTheSameAsJson) {
    Kit const kit;
    nlohmann::json const all = nlohmann::json::parse(notationJson(kit.registry).dump());
    ASSERT_EQ(all["components"].size(), kit.registry.components().size());
    nlohmann::json const& dynamics = all["components"][0];
    EXPECT_EQ(dynamics["title"], "Dynamics Resolver");
    EXPECT_EQ(dynamics["kind"], "resolver");
    EXPECT_EQ(dynamics["writes"], (nlohmann::json{"Position", "Velocity", "Angular Velocity", "Rotation"}));
    EXPECT_EQ(dynamics["calls"][0]["name"], "addForceToPoint");
    EXPECT_EQ(dynamics["calls"][0]["algebra"], "sum, held");
    ASSERT_EQ(all["schedule"]["edges"].size(), 1U);
    EXPECT_EQ(all["schedule"]["edges"][0]["before"], "Dynamics Resolver");
    EXPECT_EQ(all["schedule"]["edges"][0]["after"], "Buoyancy Resolver");
    EXPECT_EQ(all["schedule"]["beside"].size(), 5U); // of six pairs of resolvers
}

TEST(Notation, LeavesAlternativesOutOfTheSchedule) {
    Registry registry;
    registry.component<heat::Stove>();
    registry.component<heat::Furnace>();
    EXPECT_EQ(notationText(registry).find("Stove Resolver before"), std::string::npos);
    EXPECT_EQ(notationText(registry).find("Stove Resolver beside"), std::string::npos);
}

} // namespace
} // namespace trembler
