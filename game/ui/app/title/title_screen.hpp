// The title screen: the name, a bell that rings for a moment, and where to go from here.
#pragma once

#include "game/ui/shared/screen.hpp"
#include "game/ui/shared/ui_context.hpp"
#include "render/panels/buttons.hpp"

namespace trembler::ui {

class TitleScreen;
/// The table of the title screen's commands.
[[nodiscard]] std::span<Command<TitleScreen> const> titleCommands();

/// Window thread only; the context must outlive it.
class TitleScreen final : public Screen {
public:
    explicit TitleScreen(UiContext& context) : context_(context), commands_(titleCommands(), *this) {}

    std::optional<ScreenRequest> update(double seconds) override;
    void updateBehindMenu(double seconds) override;
    /// The picture behind the cards.
    void draw() override;
    /// Nothing moves once the bell has stopped.
    [[nodiscard]] bool still() const override;
    [[nodiscard]] CommandSet& commands() override { return commands_; }
    [[nodiscard]] std::filesystem::path const& level() const override { return none_; }
    /// Sets the request that the next update() returns, unless another call replaces it.
    void ask(ScreenRequest request) { request_ = std::move(request); }

private:
    void drawTitle();
    void drawButtons();
    bool drawButton(char const* label, char const* item, render::Icon icon, render::ButtonLook look,
                    float width);
    void pass(double seconds);

    UiContext& context_;
    CommandsOf<TitleScreen> commands_;
    std::filesystem::path none_;
    std::optional<ScreenRequest> request_; // of this picture
    double rings_ = 3.2;                   // s for which the bell still rings
};

} // namespace trembler::ui
