// The registered components compared with the boxes of the thesis's better apportionment (6.13). Intended
// differences are listed and explained in docs/apportionment.md; any other difference fails, and so does a
// line there that no longer applies.
#include "runtime/notation/boxes.hpp"
#include "runtime/schedule/schedule.hpp"
#include "tests/support/experiment.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace trembler {
namespace {

using Names = std::set<std::string>;

// One box of 6.13, with our names.
struct ThesisBox {
    std::string title; ///< of our component
    Names read;
    Names written{};
    Names offered{};   ///< resolver properties, derived properties
    Names functions{}; ///< interaction functions
};

std::vector<ThesisBox> const& boxes() {
    static std::vector<ThesisBox> const all{
        {"Dynamics Resolver",
         {"Position", "Velocity", "Angular Velocity", "Rotation", "Shape", "Mass", "Liquid"},
         {"Position", "Velocity", "Angular Velocity", "Rotation"},
         {"C_C", "C_N", "C_P"},
         {"addForceToPoint"}},
        {"Electricity Resolver", {"G_E"}, {"G_E"}, {}, {"addConnection", "removeConnection"}},
        {"Magnetics Resolver", {}, {"Magnet on/off"}, {}, {"enableMagnet", "disableMagnet"}},
        {"Buoyancy Resolver",
         {"Position", "Rotation", "Shape", "Density", "Liquid"},
         {},
         {"Linear gravity vector", "F_B", "COB"},
         {"setLinearGravity"}},
        // One box, "either single-wire or two-wire": two components.
        {"Single-cable Electricity DPS", {"G_E"}, {}, {"Electrical state"}},
        {"Two-wire Electricity DPS", {"G_E"}, {}, {"Electrical state"}},
        {"Magnetic Forces DPS",
         {"Position", "Rotation", "Magnetic poles", "Magnetic strength", "Magnet on/off"},
         {},
         {"F_M"}},
        {"Linear Gravity DPS", {}, {}, {"F_G"}},
        {"Real Gravity DPS", {"Position", "Mass"}, {}, {"F_G"}},
        {"(Dynamics <- Gravity) Interaction", {"Position", "F_G"}},
        {"(Electricity <- Dynamics) Interaction", {"C_N", "C_P", "Conductor"}},
        {"(Dynamics <- Magnetic Forces) Interaction", {"Position", "Magnetic poles", "F_M"}},
        {"(Magnetics <- Electricity) Interaction", {"Electrical state", "Is an electromagnet"}},
    };
    return all;
}

// The property boxes of 6.13.1.
constexpr std::array<std::string_view, 14> thesisProperties{
    "Position",  "Velocity", "Angular Velocity",  "Rotation",       "Mass",          "Shape",
    "Conductor", "G_E",      "Magnetic strength", "Magnetic poles", "Magnet on/off", "Is an electromagnet",
    "Density",   "Liquid"};

// A difference: component, set, sign and name, as "Dynamics Resolver | read | + Fixed".
using Differences = std::set<std::string>;

std::string trimmed(std::string const& text) {
    std::size_t const begin = text.find_first_not_of(' ');
    std::size_t const end = text.find_last_not_of(' ');
    return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

std::vector<std::string> split(std::string const& text, char at) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, at);) {
        parts.push_back(trimmed(part));
    }
    return parts;
}

// Several resolver properties may be kept in one: "C_C, C_N, C_P".
Names namesOf(std::vector<PropertyInfo const*> const& properties) {
    Names names;
    for (PropertyInfo const* property : properties) {
        for (std::string const& name : split(std::string(property->text.name), ',')) {
            names.insert(name);
        }
    }
    return names;
}

void compare(std::string const& title, std::string const& set, Names const& ours, Names const& thesis,
             Differences& into) {
    for (std::string const& name : ours) {
        if (!thesis.contains(name)) {
            into.insert(title + " | " + set + " | + " + name);
        }
    }
    for (std::string const& name : thesis) {
        if (!ours.contains(name)) {
            into.insert(title + " | " + set + " | − " + name);
        }
    }
}

// The lines of the table in the document, one for each name, with their reasons.
std::map<std::string, std::string> onPurpose() {
    std::map<std::string, std::string> all;
    std::ifstream file(std::string(TREMBLER_SOURCE_DIR) + "/docs/apportionment.md");
    EXPECT_TRUE(file);
    for (std::string line; std::getline(file, line);) {
        std::vector<std::string> const cells = split(line, '|');
        if (cells.size() != 5 || cells[1] == "Component" || cells[1].starts_with("---")) {
            continue;
        }
        std::string const sign = cells[3].substr(0, cells[3].find(' '));
        EXPECT_TRUE(sign == "+" || sign == "−") << line;
        for (std::string const& name : split(cells[3].substr(sign.size()), ',')) {
            bool const isNew =
                all.emplace(cells[1] + " | " + cells[2] + " | " + sign + " " + name, cells[4]).second;
            EXPECT_TRUE(isNew) << "duplicate line: " << line;
        }
    }
    return all;
}

class Apportionment : public Experiment {
protected:
    static ComponentInfo const* named(std::string const& wanted) {
        for (Registration const& component : gameData().registry.components()) {
            if (title(*component.info) == wanted) {
                return component.info;
            }
        }
        return nullptr;
    }
};

TEST_F(Apportionment, IsTheThesissExceptForTheDifferencesInTheTable) {
    Differences found;
    for (ThesisBox const& box : boxes()) {
        ComponentInfo const* const info = named(box.title);
        ASSERT_NE(info, nullptr) << box.title;
        Names functions;
        for (CallInfo const& call : info->calls) {
            functions.insert(std::string(call.text.name));
        }
        compare(box.title, "read", namesOf(allRead(*info)), box.read, found);
        compare(box.title, "written", namesOf(info->writes), box.written, found);
        compare(box.title, "offered", namesOf(info->offers), box.offered, found);
        compare(box.title, "functions", functions, box.functions, found);
    }
    std::map<std::string, std::string> const stated = onPurpose();
    EXPECT_GT(stated.size(), 20U);
    for (std::string const& difference : found) {
        EXPECT_TRUE(stated.contains(difference))
            << difference << "\ndiffers from 6.13 and is not in docs/apportionment.md";
    }
    for (auto const& [difference, reason] : stated) {
        EXPECT_TRUE(found.contains(difference))
            << difference << "\nis in docs/apportionment.md, but does not apply";
        EXPECT_GT(reason.size(), 10U) << difference << " has no reason";
    }
}

TEST_F(Apportionment, HasThePropertiesOfTheThesis) {
    auto const properties = gameData().registry.objectProperties();
    for (std::string_view const name : thesisProperties) {
        auto const at = std::find_if(properties.begin(), properties.end(),
                                     [&](PropertyInfo const* info) { return info->text.name == name; });
        ASSERT_NE(at, properties.end()) << name;
        NotationBox const box = boxOf(**at);
        EXPECT_EQ(box.title, std::string(name) + " Property");
        ASSERT_FALSE(box.rows.empty());
        EXPECT_EQ(box.rows.front().text, (*at)->text.meaning);
    }
}

// The engines are interchangeable: all have the same box.
TEST_F(Apportionment, AlternativesHaveTheBoxesOfTheFirst) {
    for (char const* engine : {"Chipmunk Dynamics Resolver", "ODE Dynamics Resolver"}) {
        ComponentInfo const* const other = named(engine);
        if (other == nullptr) {
            continue; // this program was built without it
        }
        ComponentInfo const& first = *named("Dynamics Resolver");
        EXPECT_EQ(namesOf(allRead(*other)), namesOf(allRead(first))) << engine;
        EXPECT_EQ(namesOf(other->writes), namesOf(first.writes)) << engine;
        EXPECT_EQ(namesOf(other->offers), namesOf(first.offers)) << engine;
    }
}

// 6.13.5: only Dynamics and Buoyancy cannot run at the same time.
TEST_F(Apportionment, HasTheScheduleOfTheThesis) {
    std::array<std::string, 4> const titles{"Dynamics Resolver", "Electricity Resolver", "Magnetics Resolver",
                                            "Buoyancy Resolver"};
    for (std::size_t i = 0; i < titles.size(); ++i) {
        for (std::size_t j = i + 1; j < titles.size(); ++j) {
            bool const dependent = i == 0 && j == 3;
            EXPECT_EQ(mayRunTogether(*named(titles[i]), *named(titles[j])), !dependent)
                << titles[i] << " and " << titles[j];
        }
    }
    Names shared;
    Names const written = namesOf(named("Dynamics Resolver")->writes);
    Names const read = namesOf(allRead(*named("Buoyancy Resolver")));
    std::set_intersection(written.begin(), written.end(), read.begin(), read.end(),
                          std::inserter(shared, shared.end()));
    EXPECT_EQ(shared, (Names{"Position", "Rotation"}))
        << "equation 6.2 also has Shape, which Dynamics reads but does not write";
}

} // namespace
} // namespace trembler
