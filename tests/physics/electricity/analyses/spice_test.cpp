// Circuits compared with ngspice, which shares no code with this project. Skipped where it is not installed.
#include "physics/electricity/analyses/spice.hpp"
#include "tests/physics/electricity/nodal_kit.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <regex>
#include <sstream>
#include <unistd.h>

namespace trembler::test {
namespace {

namespace fs = std::filesystem;

bool installed() {
    static bool const found = std::system("command -v ngspice > /dev/null 2>&1") == 0;
    return found;
}

/// The numbers that ngspice prints, by name of node or source.
std::map<std::string, double> runSpice(std::string const& netlist) {
    fs::path const file = fs::temp_directory_path() / ("trembler-spice-" + std::to_string(getpid()) + ".cir");
    std::ofstream(file) << netlist;
    std::string output;
    if (FILE* const pipe = popen(("ngspice -b " + file.string() + " 2>&1").c_str(), "r")) {
        std::array<char, 4096> buffer{};
        while (std::size_t const got = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
            output.append(buffer.data(), got);
        }
        pclose(pipe);
    }
    fs::remove(file);
    std::map<std::string, double> values;
    std::istringstream lines(output);
    std::regex const value(R"(^([a-z][a-z0-9_#]*) = ([-+0-9.e]+)$)");
    for (std::string line; std::getline(lines, line);) {
        if (std::smatch match; std::regex_match(line, match, value)) {
            values[match[1]] = std::stod(match[2]);
        }
    }
    return values;
}

/// The objects of the nodes and sources, from the netlist's own comments.
std::map<std::string, std::vector<std::string>> namesIn(std::string const& netlist) {
    std::map<std::string, std::vector<std::string>> names;
    std::istringstream lines(netlist);
    std::regex const heading(R"(^\* (n[0-9]+ =|v[0-9]+: source|0 =) (.*)$)");
    std::regex const quoted("'([^']*)'");
    for (std::string line; std::getline(lines, line);) {
        if (std::smatch match; std::regex_match(line, match, heading)) {
            std::string const key = match[1].str().substr(0, match[1].str().find_first_of(" :"));
            std::string const list = match[2];
            for (std::sregex_iterator at(list.begin(), list.end(), quoted); at != std::sregex_iterator();
                 ++at) {
                names[key].push_back((*at)[1]);
            }
        }
    }
    return names;
}

/// Compares potentials and source currents; returns how many numbers it compared.
int compare(NodalWorld& circuit, double tolerance) {
    std::string const netlist = spiceNetlist(circuit.store(), "test");
    auto const values = runSpice(netlist);
    double largest = 0;
    for (auto const& entry : circuit.quantities().byIndex) {
        largest = std::max(largest, entry.current);
    }
    int compared = 0;
    for (auto const& [key, objects] : namesIn(netlist)) {
        for (std::string const& object : objects) {
            auto const entry = circuit.at(object);
            if (key.starts_with('v')) {
                auto const at = values.find(key + "#branch");
                EXPECT_NE(at, values.end()) << key << " of " << netlist;
                // Positive into the source's plus pole; the source's power is V I.
                double const emf = circuit.store().column<Emf>()[circuit[object]].voltage;
                if (at != values.end()) {
                    EXPECT_NEAR(-at->second * emf, entry.supplied,
                                tolerance * (std::abs(emf) * largest + 1e-9))
                        << object << " in\n"
                        << netlist;
                }
            } else if (key != "0") {
                auto const at = values.find(key);
                EXPECT_NE(at, values.end()) << key << " of " << netlist;
                if (at != values.end()) {
                    EXPECT_NEAR(at->second, entry.potential, tolerance * 20) << object << " in\n" << netlist;
                }
            } else {
                EXPECT_EQ(entry.potential, 0);
            }
            ++compared;
        }
    }
    return compared;
}

TEST(ElectricitySpice, AnUnbalancedBridgeIsTheSame) {
    if (!installed()) {
        GTEST_SKIP() << "ngspice is not installed";
    }
    NodalWorld circuit;
    circuit.battery("plus", 10, 0.3);
    circuit.returning("minus");
    circuit.resistor("r1", 10);
    circuit.resistor("r2", 20);
    circuit.resistor("r3", 30);
    circuit.resistor("r4", 47);
    circuit.lamp("lamp", 5, 1);
    circuit.wire({{"plus", "r1", "left", "r3", "minus"},
                  {"plus", "r2", "right", "r4", "minus"},
                  {"left", "lamp", "right", "dead end"},
                  {"island", "other end"}});
    circuit.begin();
    EXPECT_EQ(compare(circuit, 1e-9), 11); // ten objects, and the source's current
}

TEST(ElectricitySpice, RandomCircuitsAreTheSame) {
    if (!installed()) {
        GTEST_SKIP() << "ngspice is not installed";
    }
    std::mt19937 random(5);
    int compared = 0;
    for (int round = 0; round < 25; ++round) {
        NodalWorld circuit;
        int const count = 5 + static_cast<int>(random() % 30);
        std::vector<std::string> names;
        for (int i = 0; i < count; ++i) {
            names.push_back("object " + std::to_string(i));
            switch (i == 0 ? 0 : i == 1 ? 1 : random() % 8) {
            case 0:
                circuit.battery(names.back(), static_cast<double>(random() % 240) / 10,
                                static_cast<double>(1 + random() % 50) / 10);
                break;
            case 1:
                circuit.returning(names.back());
                break;
            case 2:
            case 3:
                circuit.conductor(names.back());
                break;
            default:
                circuit.resistor(names.back(), std::pow(10.0, static_cast<double>(random() % 50) / 10 - 1));
            }
        }
        for (int i = 0; i < 2 * count; ++i) {
            std::string const& a = names[random() % names.size()];
            std::string const& b = names[random() % names.size()];
            if (a != b) {
                circuit.wire({{a, b}});
            }
        }
        circuit.begin();
        compared += compare(circuit, 1e-8);
    }
    EXPECT_GT(compared, 300);
}

TEST(ElectricitySpice, NamesTheObjectsAndLeavesIslandsOut) {
    NodalWorld circuit;
    circuit.battery("plus", 9);
    circuit.battery("second", 9);
    circuit.returning("minus");
    circuit.resistor("line\nbreak", 3);
    circuit.resistor("island", 3);
    circuit.wire({{"plus", "second", "line\nbreak", "minus"}, {"island", "end"}});
    circuit.begin();
    std::string const netlist = spiceNetlist(circuit.store(), "a title");
    for (char const* const line :
         {"* a title, as Trembler has it\n", "* 0 = 'minus'\n", "* n1 = 'plus', 'second'\n",
          "* n2 = 'line break'\n", "v1 n1 0 dc 9\n", "r1 n1 n2 1.5\n", "r2 0 n2 1.5\n",
          "* source 'second': like the ideal source above it\n", "* 'plus' to 'second', by level\n",
          "* r1: 'second' to 'line break', by level\n"}) {
        EXPECT_NE(netlist.find(line), std::string::npos) << line << "in\n" << netlist;
    }
    EXPECT_EQ(netlist.find("v2"), std::string::npos);
    NodalWorld onOff;
    onOff.source("plus");
    onOff.returning("minus");
    onOff.wire({{"plus", "lamp", "minus"}});
    onOff.begin();
    EXPECT_EQ(spiceNetlist(onOff.store(), ""), "");
}

} // namespace
} // namespace trembler::test
