// Uses everything in the editor's window once, and notes what it changes in the level.
#pragma once

#include "tests/game/ui/edit/whole/schema_places.hpp"

#include <set>
#include <string>
#include <vector>

namespace trembler::ui::test {

/// Uses every widget and every command once, and takes the change back.
class EveryWidget {
public:
    explicit EveryWidget(Designer& designer) : designer_(designer) {}

    /// What has changed so far.
    Places places;

    /// Of widgets that are alike, as the texts of hints, one is used; and of those that were on the page
    /// before, as another object or goal was chosen, none again.
    void usePage(Tab tab);
    void runEveryCommand();

    /// Pictures after which the editor has read and checked the level, however long that takes.
    static constexpr int pause = 20;

private:
    /// Notes what has changed since the level was opened, and undoes it.
    bool takeBack();
    void leaveField();
    void use(std::string const& item);
    /// The first choices of a list that has dropped down, or, if each may make something else, all of them.
    [[nodiscard]] std::vector<std::string> choicesOf(std::string const& item);
    /// An open list gives each of its choices; a field takes a word.
    void chooseOrType(std::string const& item);

    Designer& designer_;
    std::set<std::string> used_;
};

} // namespace trembler::ui::test
