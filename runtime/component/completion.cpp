#include "runtime/component/completion.hpp"

#include "runtime/component/rule_broken.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {
namespace {

bool holds(std::vector<PropertyInfo const*> const& list, PropertyInfo const* property) {
    return std::find(list.begin(), list.end(), property) != list.end();
}

// A property that `first` adds and that `second` reads or needs, or nullptr.
PropertyInfo const* needed(CompletionInfo const& first, CompletionInfo const& second) {
    for (PropertyInfo const* property : first.adds) {
        if (holds(second.reads, property) || holds(second.neededAll, property) ||
            holds(second.neededAny, property)) {
            return property;
        }
    }
    return nullptr;
}

void refuseRivals(CompletionInfo const& a, CompletionInfo const& b) {
    if (a.text.name == b.text.name) {
        throw RuleBroken(fmt::format("two completions are called {}", title(a)));
    }
    for (PropertyInfo const* property : a.adds) {
        if (holds(b.adds, property)) {
            throw RuleBroken(fmt::format("the {} and the {} both add {}, and what is there stays: the first "
                                         "one would win",
                                         title(a), title(b), property->text.name));
        }
    }
}

// Each completion in `waiting` must follow another one in it. Goes back along these relations until a
// completion repeats.
[[noreturn]] void throwCycle(std::vector<CompletionInfo const*> const& waiting) {
    std::vector<CompletionInfo const*> path{waiting.front()};
    for (;;) {
        CompletionInfo const* const last = path.back();
        CompletionInfo const* const before =
            *std::find_if(waiting.begin(), waiting.end(), [&](CompletionInfo const* other) {
                return other != last && needed(*other, *last) != nullptr;
            });
        auto const seen = std::find(path.begin(), path.end(), before);
        if (seen == path.end()) {
            path.push_back(before);
            continue;
        }
        path.erase(path.begin(), seen);
        std::string circle;
        for (std::size_t i = 0; i < path.size(); ++i) {
            CompletionInfo const& reader = *path[i];
            CompletionInfo const& adder = *path[(i + 1) % path.size()];
            circle += fmt::format("{}the {} reads {}, which the {} adds", i == 0 ? "" : "; ", title(reader),
                                  needed(adder, reader)->text.name, title(adder));
        }
        throw RuleBroken("completions have no order: " + circle);
    }
}

} // namespace

std::string title(CompletionInfo const& info) {
    return std::string(info.text.name) + " Completion";
}

std::vector<CompletionInfo const*> completionOrder(std::span<CompletionInfo const* const> completions) {
    for (std::size_t i = 0; i < completions.size(); ++i) {
        for (std::size_t j = i + 1; j < completions.size(); ++j) {
            refuseRivals(*completions[i], *completions[j]);
        }
    }
    std::vector<CompletionInfo const*> waiting(completions.begin(), completions.end());
    std::vector<CompletionInfo const*> ordered;
    while (!waiting.empty()) {
        auto const next = std::find_if(waiting.begin(), waiting.end(), [&](CompletionInfo const* candidate) {
            return std::none_of(waiting.begin(), waiting.end(), [&](CompletionInfo const* other) {
                return other != candidate && needed(*other, *candidate) != nullptr;
            });
        });
        if (next == waiting.end()) {
            throwCycle(waiting);
        }
        ordered.push_back(*next);
        waiting.erase(next);
    }
    return ordered;
}

} // namespace trembler
