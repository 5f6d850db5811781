#include "tests/lua/analysis/interaction_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler::lua::analysis {
namespace {

Comparison const* comparisonOf(std::vector<Comparison> const& compared, std::string const& name) {
    auto const at = std::find_if(compared.begin(), compared.end(),
                                 [&](Comparison const& comparison) { return comparison.name == name; });
    return at == compared.end() ? nullptr : &*at;
}

std::string verdictOn(Comparison const& comparison) {
    if (comparison.plays == 0) {
        return "activated nowhere";
    }
    if (!comparison.firstDiffers) {
        return "equal";
    }
    return fmt::format("{} plays differ, first after frame {}: {}", comparison.differing,
                       *comparison.firstDiffers, comparison.differsIn);
}

} // namespace

std::string hashTable(std::vector<Comparison> const& compared) {
    std::string table = "| interaction | lines of C++ | lines of Lua | plays | frames | worlds | remark |\n"
                        "|---|--:|--:|--:|--:|---|---|\n";
    int native = 0;
    int script = 0;
    for (Counterpart const& counterpart : counterparts()) {
        Comparison const* const comparison = comparisonOf(compared, counterpart.name);
        if (comparison == nullptr) {
            table += fmt::format("| {} | {} | – | | | not written | {} |\n", counterpart.name,
                                 nativeLines(counterpart), counterpart.remark);
            continue;
        }
        native += nativeLines(counterpart);
        script += scriptLines(counterpart);
        table += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", counterpart.name,
                             nativeLines(counterpart), scriptLines(counterpart), comparison->plays,
                             comparison->frames, verdictOn(*comparison), counterpart.remark);
    }
    return table + fmt::format("| all that are written | {} | {} | | | | |\n", native, script);
}

std::string timeTable(std::vector<Comparison> const& compared) {
    std::string table = "| interaction | turns | C++ (µs) | Lua (µs) | ratio |\n|---|--:|--:|--:|--:|\n";
    for (Comparison const& comparison : compared) {
        if (comparison.turns > 0) {
            table +=
                fmt::format("| {} | {} | {:.2f} | {:.1f} | {:.0f} |\n", comparison.name, comparison.turns,
                            comparison.nativeMicroseconds, comparison.scriptMicroseconds,
                            comparison.scriptMicroseconds / comparison.nativeMicroseconds);
        }
    }
    return table;
}

} // namespace trembler::lua::analysis
