#include "tests/game/ui/readable.hpp"

#include "render/panels/theme.hpp"
#include "tests/game/ui/drawn_text.hpp"

#include <vector>

namespace trembler::ui::test {
namespace {

Rect shrunk(Rect const& rect, double by) {
    return {rect.low + Point{by, by}, rect.high - Point{by, by}};
}

/// Tips and toasts lie over everything for a moment, by design.
bool liesOver(DrawnText const& text) {
    return text.window.starts_with("##Tooltip") || text.window == "##Foreground";
}

} // namespace

void expectReadable(std::string const& where) {
    render::Size const size = window().size();
    std::vector<DrawnText> const texts = drawnTexts();
    EXPECT_FALSE(texts.empty()) << where;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        DrawnText const& text = texts[i];
        bool const ofScene = text.window == "##Background"; // the scene may reach beyond the window
        EXPECT_TRUE(ofScene || (text.rect.low.x > -1 && text.rect.low.y > -1 &&
                                text.rect.high.x < size.width + 1 && text.rect.high.y < size.height + 1))
            << where << ": \"" << text.text << "\" leaves the window";
        // Fields of the editor's pages scroll with their cursor.
        bool const inField = text.window.starts_with("panel/");
        EXPECT_FALSE(!ofScene && !inField && text.cutAcross)
            << where << ": \"" << text.text << "\" is cut at a side";
        EXPECT_FALSE(!ofScene && !inField && text.cutAlong && !text.scrolled)
            << where << ": \"" << text.text << "\" is cut above or below";
        // Only the content below a card's heading may scroll.
        bool const heading = text.line > render::theme().fonts.heading->FontSize - 1;
        EXPECT_FALSE(text.cutAlong && heading && text.window.starts_with("goal"))
            << where << ": the heading \"" << text.text << "\" is cut above or below";
        for (std::size_t j = 0; j < i && !liesOver(text); ++j) {
            if (texts[j].window != text.window) {
                continue;
            }
            EXPECT_FALSE(shrunk(text.rect, 1).overlaps(shrunk(texts[j].rect, 1)))
                << where << ": \"" << text.text << "\" lies on \"" << texts[j].text << "\"";
            EXPECT_FALSE(breaksANumber(texts[j], text))
                << where << ": a number is broken: \"" << texts[j].text << "\" | \"" << text.text << "\"";
        }
    }
}

void expectWordsFit(Player& player, std::string const& where) {
    for (DrawnText const& text : drawnTexts()) {
        for (Placed const& item : player.layout().items()) {
            bool const on = !liesOver(text) && text.window != "##Background" &&
                            item.rect.contains(text.rect.middle()) && item.name.find("part ") != 0;
            EXPECT_FALSE(on &&
                         (text.rect.low.x < item.rect.low.x - 1 || text.rect.high.x > item.rect.high.x + 1))
                << where << ": \"" << text.text << "\" reaches beyond \"" << item.name << "\"";
        }
    }
}

} // namespace trembler::ui::test
