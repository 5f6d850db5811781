#include "game/ui/app/menu/chapters_page.hpp"

#include "game/ui/app/menu/level_card.hpp"
#include "game/ui/shared/texts.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace trembler::ui {
namespace {

using namespace render;

constexpr float mostWidth = 1100; // of the page, pixels at UI scale 1
constexpr float cardGapHere = 12;

/// "3/8": how many levels of a chapter are solved.
std::string countOf(UiContext const& context, CatalogGroup const& chapter) {
    auto const solved =
        std::count_if(chapter.levels.begin(), chapter.levels.end(),
                      [&](CatalogEntry const& level) { return context.profile.solved(level.id); });
    return std::to_string(solved) + "/" + std::to_string(chapter.levels.size());
}

} // namespace

void ChaptersPage::open(UiContext const& context, std::filesystem::path const& current, bool gallery) {
    auto const& chapters = context.levels.groups();
    CatalogEntry const* wanted = current.empty() ? nullptr : context.levels.find(current);
    if (wanted == nullptr) {
        wanted = context.levels.next(context.profile.progress());
    }
    chapter_ = chapters.size();
    for (std::size_t i = 0; i < chapters.size(); ++i) {
        auto const& levels = chapters[i].levels;
        bool const here = std::any_of(levels.begin(), levels.end(),
                                      [&](CatalogEntry const& entry) { return &entry == wanted; });
        if (chapters[i].gallery == gallery && (here || chapter_ == chapters.size())) {
            chapter_ = i; // the first, unless another has the wanted level
        }
    }
}

void ChaptersPage::drawTabs(UiContext& context) {
    auto const& chapters = context.levels.groups();
    std::string const language(languageInUse());
    float const right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    bool first = true;
    for (std::size_t i = 0; i < chapters.size(); ++i) {
        if (chapters[i].gallery != chapters[chapter_].gallery) { // demonstrations have a page of their own
            continue;
        }
        std::string const label =
            titleIn(chapters[i].texts, language, chapters[i].title) + "  " + countOf(context, chapters[i]);
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(scaled(11), scaled(7)));
        float const width = ImGui::CalcTextSize(label.c_str()).x + scaled(22);
        if (!std::exchange(first, false) && ImGui::GetItemRectMax().x + scaled(8) + width <= right) {
            ImGui::SameLine(0, scaled(8));
        }
        bool const on = i == chapter_;
        if (on) {
            ImGui::PushStyleColor(ImGuiCol_Button, imColour4(palette::accent));
            ImGui::PushStyleColor(ImGuiCol_ButtonHovered, imColour4(palette::accent));
            ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::paperLight));
        }
        bool chosen = ImGui::Button((label + "##" + std::to_string(i)).c_str());
        context.layout.item("chapter " + std::to_string(i + 1));
        if (on) {
            ImGui::PopStyleColor(3);
        }
        ImGui::PopStyleVar();
        chosen = context.focus.item() || chosen;
        chapter_ = chosen ? i : chapter_;
    }
}

CatalogEntry const* ChaptersPage::drawCards(UiContext& context, CatalogGroup const& chapter,
                                            CatalogEntry const* here) {
    CatalogEntry const* chosen = nullptr;
    CatalogEntry const* const next = context.levels.next(context.profile.progress());
    float const step = levelCardWidth + cardGapHere;
    float const width = ImGui::GetContentRegionAvail().x / theme().scale;
    constexpr float ring = 3; // room for that of the focus
    auto const columns = static_cast<std::size_t>(std::max((width + cardGapHere - 2 * ring) / step, 1.F));
    float const share = (width - 2 * ring + cardGapHere) / static_cast<float>(columns) - cardGapHere;
    ImGui::Indent(scaled(ring));
    for (std::size_t i = 0; i < chapter.levels.size(); ++i) {
        if (i % columns != 0) {
            ImGui::SameLine(0, scaled(cardGapHere));
        }
        CatalogEntry const& entry = chapter.levels[i];
        if (drawLevelCard(context, entry,
                          {.current = &entry == here, .next = &entry == next, .width = share})) {
            chosen = &entry;
        }
    }
    ImGui::Unindent(scaled(ring));
    return chosen;
}

ChaptersPage::Choice ChaptersPage::draw(UiContext& context, std::filesystem::path const& current) {
    Choice choice;
    auto const& chapters = context.levels.groups();
    ImVec2 const screen = ImGui::GetIO().DisplaySize;
    float const width = std::min(screen.x / theme().scale - 32, mostWidth);
    bool const none = chapter_ >= chapters.size();
    bool const gallery = !none && chapters[chapter_].gallery;
    context.layout.beginCard("level list", text(gallery ? "title.gallery" : "levels.title"),
                             {.anchor = Anchor::Middle, .width = width});
    if (none) {
        caption(text("levels.none"));
    } else {
        auto const alike = [&](CatalogGroup const& chapter) { return chapter.gallery == gallery; };
        if (std::count_if(chapters.begin(), chapters.end(), alike) > 1) {
            drawTabs(context);
        }
        CatalogGroup const& chapter = chapters[chapter_];
        if (std::string const about = textIn(chapter.texts, std::string(languageInUse()), chapter.text);
            !about.empty()) {
            caption(about.c_str());
        }
        CatalogEntry const* const here = current.empty() ? nullptr : context.levels.find(current);
        // The button below, with the gaps around it and the card's padding.
        float const rest = scaled(112) + (ImGui::GetCursorScreenPos().y - ImGui::GetWindowPos().y);
        ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(scaled(cardGapHere), scaled(cardGapHere)));
        ImGui::BeginChild(("cards " + std::to_string(chapter_)).c_str(),
                          {0, std::max(screen.y - rest, scaled(120))});
        ImGui::Dummy({0, 0});
        choice.level = drawCards(context, chapter, here);
        ImGui::EndChild();
        ImGui::PopStyleVar();
        ImGui::PopStyleColor();
    }
    ImGui::Dummy({0, scaled(2)});
    bool const back = bigButton(text("menu.back"), {.icon = Icon::Back, .width = 200});
    context.layout.item("Back");
    choice.back = context.focus.item() || back;
    context.layout.endCard();
    return choice;
}

} // namespace trembler::ui
