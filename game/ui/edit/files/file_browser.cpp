#include "game/ui/edit/files/file_browser.hpp"

#include "game/ui/edit/edit_words.hpp"
#include "game/ui/shared/words.hpp"
#include "render/draw/palette.hpp"
#include "render/panels/buttons.hpp"
#include "render/panels/theme.hpp"
#include "render/window/gamepad.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

namespace trembler::ui {
namespace {

using namespace render;
namespace fs = std::filesystem;

constexpr float browserWidth = 520;
constexpr std::size_t mostEntries = 2000;

/// Levels and solutions have the same kind of names.
bool isLevelName(std::string const& name) {
    return name.ends_with(".json") && !name.ends_with(".schema.json");
}

char const* titleFor(FileBrowser::Purpose purpose) {
    switch (purpose) {
    case FileBrowser::Purpose::saveAs:
        return words::saveAsTitle;
    case FileBrowser::Purpose::openSolution:
        return words::openSolutionTitle;
    case FileBrowser::Purpose::open:
        break;
    }
    return words::openTitle;
}

} // namespace

bool textField(char const* label, std::string& text, std::size_t longest, bool onEnter) {
    std::string buffer = text.substr(0, longest);
    buffer.resize(longest + 1);
    bool const done = ImGui::InputText(label, buffer.data(), buffer.size(),
                                       onEnter ? ImGuiInputTextFlags_EnterReturnsTrue : 0);
    if (std::string const now = buffer.c_str(); now != text) {
        text = now;
        return onEnter ? done : true;
    }
    return onEnter && done;
}

void FileBrowser::begin(Purpose purpose, fs::path const& start) {
    purpose_ = purpose;
    open_ = true;
    fresh_ = true;
    name_.clear();
    std::error_code ignored;
    fs::path folder = fs::absolute(start.empty() ? fs::path(".") : start, ignored).lexically_normal();
    if (!fs::is_directory(folder, ignored)) {
        name_ = folder.filename().string();
        folder = folder.parent_path();
    }
    enter(folder);
}

void FileBrowser::enter(fs::path const& folder) {
    replace_ = false;
    trouble_.clear();
    std::vector<Entry> entries;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        std::error_code unknown;
        std::string name = at->path().filename().string();
        bool const isFolder = at->is_directory(unknown);
        if (name.starts_with(".") || (!isFolder && !isLevelName(name)) || entries.size() >= mostEntries) {
            continue;
        }
        entries.push_back({std::move(name), isFolder});
    }
    if (error) {
        trouble_ = words::cannotReadFolder(folder.string(), error.message());
        if (!folder_.empty()) {
            return; // the list shown before stays
        }
    }
    std::sort(entries.begin(), entries.end(), [](Entry const& a, Entry const& b) {
        return a.folder != b.folder ? a.folder : naturallyBefore(a.name, b.name);
    });
    folder_ = folder;
    entries_ = std::move(entries);
}

std::optional<fs::path> FileBrowser::choose(std::string const& stated) {
    if (stated.empty()) {
        return {};
    }
    std::error_code ignored;
    fs::path file = folder_ / stated;
    if (fs::is_directory(file, ignored)) {
        name_.clear();
        enter(file.lexically_normal());
        return {};
    }
    if (purpose_ != Purpose::saveAs) {
        if (!fs::exists(file, ignored)) {
            trouble_ = words::noSuchFile(stated);
            return {};
        }
    } else {
        if (file.extension() != ".json") {
            file += ".json";
        }
        if (fs::exists(file, ignored) && !replace_) {
            replace_ = true;
            trouble_ = words::replaceFile(file.filename().string());
            return {};
        }
    }
    open_ = false;
    return file;
}

void FileBrowser::drawEntries(UiContext& context, std::optional<fs::path>& chosen) {
    float const room = std::max(ImGui::GetIO().DisplaySize.y / theme().scale - 330, 120.F);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, imColour4(palette::paper));
    ImGui::BeginChild("files", {0, scaled(std::min(room, 340.F))}, true);
    std::optional<std::string> picked;
    auto const row = [&](std::string const& label, std::string const& name) {
        bool const clicked = ImGui::Selectable(label.c_str(), name == name_);
        context.layout.item("file " + name);
        bool const pressed = context.focus.item();
        if (context.focus.here()) {
            ImGui::SetScrollHereY();
        }
        if (clicked || pressed) {
            picked = name;
        }
    };
    row(words::parentFolder, "..");
    for (Entry const& entry : entries_) {
        row(entry.folder ? entry.name + "/" : entry.name, entry.name);
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
    if (!picked) {
        return;
    }
    std::error_code unknown; // what cannot be looked at is no folder
    if (*picked == "..") {
        enter(folder_.parent_path());
    } else if (purpose_ == Purpose::saveAs && !fs::is_directory(folder_ / *picked, unknown)) {
        name_ = *picked;
        replace_ = false;
    } else {
        chosen = choose(*picked);
    }
}

std::optional<fs::path> FileBrowser::draw(UiContext& context) {
    if (context.menuKeys.pressed(MenuKey::back)) {
        close();
        return {};
    }
    bool const typing = context.gui.wantsKeyboard();
    context.focus.begin("file browser",
                        typing ? std::span<MenuKeys::Press const>() : context.menuKeys.presses(),
                        context.input.mouseMoved() != Point{});
    std::optional<fs::path> chosen;
    bool const saving = purpose_ == Purpose::saveAs;
    context.layout.beginCard("file browser", titleFor(purpose_),
                             {.anchor = Anchor::Middle, .width = browserWidth});
    smallCaption(folder_.string().c_str());
    drawEntries(context, chosen);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(words::fileName);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    if (std::exchange(names_, false) || (fresh_ && saving)) {
        ImGui::SetKeyboardFocusHere();
    }
    fresh_ = false;
    std::string const before = name_;
    bool const entered = textField("##name", name_, 255, true);
    context.layout.item("file name");
    names_ = context.focus.item();
    if (before != name_) {
        replace_ = false;
        trouble_.clear();
    }
    if (!trouble_.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, imColour4(palette::warning));
        ImGui::TextWrapped("%s", trouble_.c_str());
        ImGui::PopStyleColor();
    }
    float const half = (ImGui::GetContentRegionAvail().x - scaled(8)) / 2 / theme().scale;
    char const* const label = !saving ? words::openFile : replace_ ? words::replaceIt : words::saveFile;
    bool agreed = bigButton(label, {.icon = saving ? Icon::Save : Icon::List,
                                    .look = replace_ ? ButtonLook::Danger : ButtonLook::Primary,
                                    .width = half,
                                    .enabled = !name_.empty()});
    context.layout.item("choose file");
    agreed = context.focus.item() || agreed;
    ImGui::SameLine(0, scaled(8));
    bool const cancelled = bigButton(words::cancel, {.icon = Icon::Cross, .width = half});
    context.layout.item("cancel file");
    if (context.focus.item() || cancelled) {
        close();
    } else if (agreed || entered) {
        chosen = choose(name_);
    }
    context.layout.endCard();
    return chosen;
}

} // namespace trembler::ui
