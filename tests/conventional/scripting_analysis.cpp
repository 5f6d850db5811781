// Prints docs/scripting-analysis.md with its tables computed again: scripting_analysis PAGE [--times]
// [--interactions]. Without --times, the table of times stays as it is, as it depends on the machine; with
// --interactions, so do the tables of the conventional scenes, which take longest.
#include "tests/conventional/trials.hpp"
#include "tests/lua/analysis/interaction_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>

namespace {

// Puts a table between the marks of its name.
void put(std::string& page, std::string const& name, std::string const& table) {
    std::string const begin = fmt::format("<!-- table {} -->\n", name);
    std::string const end = "<!-- end -->";
    std::size_t const from = page.find(begin);
    std::size_t const to = from == std::string::npos ? from : page.find(end, from);
    if (to == std::string::npos) {
        throw std::runtime_error("the page has no place for the table " + name);
    }
    page.replace(from + begin.size(), to - from - begin.size(), "\n" + table + "\n");
}

} // namespace

int main(int count, char** arguments) try {
    using namespace trembler;
    std::vector<std::string> const stated(arguments + 1, arguments + count);
    auto const states = [&](std::string const& word) {
        return std::find(stated.begin(), stated.end(), word) != stated.end();
    };
    if (stated.empty() || stated.front().starts_with("--") ||
        stated.size() != 1U + (states("--times") ? 1U : 0U) + (states("--interactions") ? 1U : 0U)) {
        std::cerr << "usage: scripting_analysis PAGE [--times] [--interactions]\n";
        return 2;
    }
    std::ifstream file(stated.front());
    std::string page{std::istreambuf_iterator<char>(file), {}};
    std::string probe = page;
    put(probe, "first", ""); // rejects any other page at once, not after minutes of plays
    GameData const data;
    auto const compared = lua::analysis::compareAll(data, lua::analysis::comparedLevels(data), 100'000);
    for (auto const& comparison : compared) {
        for (std::string const& error : comparison.errors) {
            std::cerr << comparison.name << ": " << error << "\n";
        }
    }
    put(page, "hashes", lua::analysis::hashTable(compared));
    if (states("--times")) {
        put(page, "times", lua::analysis::timeTable(compared));
    }
    if (states("--interactions")) {
        std::cout << page;
        return 0;
    }
    conventional::Stage const stage;
    std::vector<conventional::SceneResult> results;
    std::string kinds;
    for (auto const& scene : conventional::allScenes()) {
        results.push_back(conventional::runTrials(*scene, stage, conventional::fullCount));
        kinds += (kinds.empty() ? "" : "\n") + conventional::kindTable(results.back());
    }
    put(page, "shares", conventional::shareTable(results));
    put(page, "kinds", kinds);
    put(page, "misses", conventional::missTable(results));
    put(page, "first", conventional::firstTable(results, conventional::shortCount));
    std::cout << page;
    return 0;
} catch (std::exception const& error) {
    std::cerr << error.what() << "\n";
    return 1;
}
