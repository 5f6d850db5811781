#include "game/ui/app/menu/solutions_page.hpp"

#include "game/ui/shared/kept/user_folders.hpp"
#include "game/ui/shared/texts.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/theme.hpp"

#include <algorithm>
#include <string>

namespace trembler::ui {
namespace {

using namespace render;

constexpr float solutionsWidth = 620; // pixels at UI scale 1

bool rowButton(UiContext& context, char const* label, std::string const& item) {
    bool const clicked = ImGui::Button((std::string(label) + "##" + item).c_str());
    context.layout.item(item);
    return context.focus.item() || clicked;
}

void tell(UiContext& context, std::string const& why) {
    if (!why.empty()) {
        context.toasts.add(why, ToastKind::Trouble, 8);
    }
}

float widthOf(char const* label) {
    return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

} // namespace

void SolutionsPage::open(LoadableSolutions& loadable) {
    loadable.refresh();
    renamed_.reset();
    asked_.reset();
    browser_.close();
}

bool SolutionsPage::cancel() {
    bool const was = typing() || browsing();
    renamed_.reset();
    browser_.close();
    return was;
}

SolutionsPage::Choice SolutionsPage::drawBrowser(UiContext& context, LoadableSolutions& loadable) {
    auto const file = browser_.draw(context);
    if (!file) {
        return Choice::stay;
    }
    folder_ = browser_.folder();
    std::string const why = loadable.receive(*file);
    tell(context, why);
    return why.empty() ? Choice::loaded : Choice::stay;
}

void SolutionsPage::startRenaming(LoadableSolutions const& loadable, std::size_t index) {
    name_.fill('\0');
    std::string const& name = loadable.items()[index].name;
    std::copy_n(name.begin(), std::min(name.size(), name_.size() - 1), name_.begin());
    renamed_ = index;
    focuses_ = true;
}

void SolutionsPage::drawName(UiContext& context, LoadableSolutions& loadable, std::size_t index) {
    ImGui::SetNextItemWidth(-1);
    if (std::exchange(focuses_, false)) {
        ImGui::SetKeyboardFocusHere();
    }
    bool const done =
        ImGui::InputText("##name", name_.data(), name_.size(),
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    context.layout.item("solution name");
    if (done) {
        if (name_[0] != '\0') {
            tell(context, loadable.rename(index, name_.data()));
        }
        renamed_.reset();
    } else if (ImGui::IsItemDeactivated()) { // given up, by a gamepad or for something else
        renamed_.reset();
    }
}

SolutionsPage::Choice SolutionsPage::drawRow(UiContext& context, LoadableSolutions& loadable,
                                             std::size_t index) {
    if (renamed_ == index) {
        drawName(context, loadable, index);
        return Choice::stay;
    }
    LoadableSolutions::Item const item = loadable.items()[index];
    std::string const number = " " + std::to_string(index + 1);
    bool const asks = asked_ == index;
    char const* const load = text("solutions.load");
    char const* const rename = text("solutions.rename");
    char const* const erase = text(asks ? "solutions.delete_ask" : "solutions.delete");
    float const gap = scaled(8);
    float buttons = widthOf(load);
    if (item.mine) {
        buttons += 2 * gap + widthOf(rename) + widthOf(erase);
    }
    float const right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    ImVec2 const at = ImGui::GetCursorScreenPos();
    ImGui::AlignTextToFramePadding();
    ImGui::PushClipRect(at, {at.x + right - ImGui::GetCursorPosX() - buttons - gap, at.y + scaled(60)}, true);
    ImGui::TextUnformatted(item.name.c_str());
    if (!item.mine) {
        ImGui::SameLine(0, gap);
        ImGui::TextColored(imColour4(palette::inkSoft), "%s", text("solutions.recorded"));
    }
    ImGui::PopClipRect();
    ImGui::SameLine(right - buttons);
    if (rowButton(context, load, "load solution" + number)) {
        std::string const why = loadable.load(index);
        tell(context, why);
        return why.empty() ? Choice::loaded : Choice::stay;
    }
    if (!item.mine) {
        return Choice::stay;
    }
    ImGui::SameLine(0, gap);
    if (rowButton(context, rename, "rename solution" + number)) {
        startRenaming(loadable, index);
        asked_.reset();
    }
    ImGui::SameLine(0, gap);
    if (rowButton(context, erase, "delete solution" + number)) {
        if (asks) {
            tell(context, loadable.remove(index));
            asked_.reset();
        } else {
            asked_ = index;
        }
    }
    return Choice::stay;
}

std::string noSolutionsYet(KeyBindings const& keys) {
    auto const save = keys.keysOf("save");
    return save.empty() ? text("solutions.none_without_key")
                        : textWith("solutions.none", labelOf(save.front()));
}

SolutionsPage::Choice SolutionsPage::draw(UiContext& context, LoadableSolutions& loadable) {
    if (browsing()) {
        return drawBrowser(context, loadable);
    }
    Choice choice = Choice::stay;
    ImVec2 const screen = ImGui::GetIO().DisplaySize;
    float const width = std::min(screen.x / theme().scale - 32, solutionsWidth);
    context.layout.beginCard("solutions", text("solutions.title"),
                             {.anchor = Anchor::Middle, .width = width});
    caption(loadable.items().empty() ? noSolutionsYet(context.keys).c_str() : text("solutions.about"));
    float const row = ImGui::GetFrameHeightWithSpacing();
    float const height = row * static_cast<float>(loadable.items().size());
    float const room = std::max(screen.y - scaled(310), row);
    bool const scrolls = height > room;
    if (scrolls) {
        ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4(0, 0, 0, 0));
        ImGui::BeginChild("rows", {0, room});
    }
    for (std::size_t i = 0; i < loadable.items().size() && choice == Choice::stay; ++i) {
        choice = drawRow(context, loadable, i);
    }
    if (scrolls) {
        ImGui::EndChild();
        ImGui::PopStyleColor();
    }
    ImGui::Dummy({0, scaled(2)});
    smallCaption(text("solutions.drop"));
    ImGui::Dummy({0, scaled(2)});
    bool const wanted = bigButton(text("solutions.open"), {.icon = Icon::List, .width = 200});
    context.layout.item("open solution");
    if (context.focus.item() || wanted) {
        browser_.begin(FileBrowser::Purpose::openSolution,
                       folder_.empty() ? usualDownloadsFolder() : folder_);
        asked_.reset();
    }
    ImGui::SameLine(0, scaled(8));
    bool const back = bigButton(text("menu.back"), {.icon = Icon::Back, .width = 200});
    context.layout.item("Back");
    if (context.focus.item() || back) {
        choice = Choice::back;
    }
    context.layout.endCard();
    return choice;
}

} // namespace trembler::ui
