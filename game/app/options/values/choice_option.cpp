#include "game/app/options/values/choice_option.hpp"

#include "game/app/options/rule/rule.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <algorithm>

namespace trembler {

CLI::Option* addChoice(CLI::App& command, std::string const& option, std::string& target,
                       std::vector<std::string> const& words, std::string const& meaning) {
    auto* const added = command.add_option(option, target, meaning);
    added->type_name(option.starts_with('-') ? "WORD" : "");
    return accepts(added, listed(words), [words](std::string const& word) {
        return std::find(words.begin(), words.end(), word) != words.end()
                   ? Fault()
                   : Fault("there is no such choice" + didYouMean(word, words));
    });
}

} // namespace trembler
