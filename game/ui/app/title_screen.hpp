// What one sees first: the name, a bell that rings itself, and the levels.
#pragma once

#include "game/ui/shared/ui_context.hpp"

namespace trembler::ui {

struct TitleChoice {
    CatalogEntry const* level = nullptr;
    bool settings = false;
    bool quit = false;
};

/// Window thread only; the context must outlive it.
class TitleScreen {
public:
    explicit TitleScreen(UiContext& context) : context_(context) {}
    /// Between Gui::beginFrame and draw(). `hidden`: a menu lies over it.
    TitleChoice update(double seconds, bool hidden);
    /// The picture behind the cards; after Window::beginFrame, before Gui::endFrame.
    void draw() const;

private:
    UiContext& context_;
    double time_ = 0; // s
};

} // namespace trembler::ui
