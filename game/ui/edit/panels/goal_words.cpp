#include "game/ui/edit/panels/goal_words.hpp"

#include "game/ui/shared/texts.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace trembler::ui {
namespace {

struct GoalWord {
    std::string_view key; // in level files
    std::string_view id;  // of its text
};

constexpr std::array<GoalWord, 26> goalWords{{{"inside", "condition.inside"},
                                              {"touching", "condition.touching"},
                                              {"on", "condition.on"},
                                              {"off", "condition.off"},
                                              {"moved", "condition.moved"},
                                              {"count", "condition.count"},
                                              {"all", "condition.all"},
                                              {"any", "condition.any"},
                                              {"not", "condition.not"},
                                              {"sequence", "condition.sequence"},
                                              {"object", "condition.object"},
                                              {"area", "condition.area"},
                                              {"called", "condition.called"},
                                              {"text", "condition.text"},
                                              {"by", "condition.by"},
                                              {"towards", "condition.towards"},
                                              {"part", "condition.part"},
                                              {"of", "condition.of"},
                                              {"at_least", "condition.at_least"},
                                              {"at_most", "condition.at_most"},
                                              {"exactly", "condition.exactly"},
                                              {"up", "condition.up"},
                                              {"down", "condition.down"},
                                              {"left", "condition.left"},
                                              {"right", "condition.right"},
                                              {"it", "condition.it"}}};

} // namespace

std::string shownGoalWord(std::string const& word) {
    auto const known = std::find_if(goalWords.begin(), goalWords.end(),
                                    [&](GoalWord const& one) { return one.key == word; });
    return known == goalWords.end() ? word : text(known->id);
}

} // namespace trembler::ui
