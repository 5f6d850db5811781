// What a player can ask for, whether by key or by button.
#pragma once

#include <cstdint>
#include <optional>

namespace trembler::ui {

enum class Command : std::uint8_t {
    runOrStop,
    pauseOrGo,
    step,
    fastForward, ///< a switch
    undo,
    redo,
    allBack, ///< asks once
    electricity,
    magnetism,
    contacts,
    names,
    components,
    budget, ///< a switch
    lessBudget,
    moreBudget,
    cut,
    record,
    picture,
    save, ///< what was placed and done, as a solution file
    fit,
    hint,
    inspect,
    menu,
    levels,
    help,
    fullscreen,
    nextLevel,
    watchAgain,
    keepPlaying,
};

} // namespace trembler::ui
