// The page of chapters: one tab for each, and a card with a picture for each level.
#pragma once

#include "game/ui/shared/ui_context.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>

namespace trembler::ui {

/// Window thread only.
class ChaptersPage {
public:
    /// Shows the chapter of `current`; if it is empty, that of the puzzle to play next. With `gallery` the
    /// first gallery.
    void open(UiContext const& context, std::filesystem::path const& current, bool gallery);

    struct Choice {
        CatalogEntry const* level = nullptr; ///< chosen in this picture; nullptr: none
        bool back = false;
    };
    /// Call between Gui::beginFrame and endFrame.
    Choice draw(UiContext& context, std::filesystem::path const& current);

private:
    void drawTabs(UiContext& context);
    [[nodiscard]] CatalogEntry const* drawCards(UiContext& context, CatalogGroup const& chapter,
                                                CatalogEntry const* here);

    std::size_t chapter_ = 0;
};

} // namespace trembler::ui
