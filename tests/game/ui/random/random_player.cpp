#include "tests/game/ui/random/random_player.hpp"

#include "game/ui/edit/edit_screen.hpp"
#include "tests/game/ui/player.hpp"

#include <array>
#include <cstdlib>

namespace trembler::ui::test {
namespace {

namespace fs = std::filesystem;
using render::Point;

constexpr int drawnEvery = 60; // pictures, as drawing takes a hundred times as long as the rest

} // namespace

RandomPlayer::RandomPlayer(render::Window& window, GameData const& data, fs::path folder, std::uint64_t seed)
    : window_(window), data_(data), folder_(fs::absolute(folder)), random_(seed) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    constexpr auto everything = fs::copy_options::recursive;
    fs::path const source(TREMBLER_SOURCE_DIR);
    fs::copy(source / "levels", folder_ / "levels", everything);
    fs::copy(source / "mods", folder_ / "mods", everything);
    for (char const* const name : {"XDG_DATA_HOME", "XDG_STATE_HOME", "XDG_CONFIG_HOME", "HOME"}) {
        ::setenv(name, folder_.c_str(), 1);
    }
    fs::current_path(folder_);
    for (char const* const part : {"levels", "mods"}) {
        for (auto const& entry : fs::recursive_directory_iterator(folder_ / part)) {
            std::string const name = entry.path().filename().string();
            if (name.ends_with(".json") && !name.ends_with(".schema.json") && name != "chapter.json") {
                levels_.push_back(entry.path());
            }
        }
    }
    std::sort(levels_.begin(), levels_.end());
    SDL_FlushEvents(SDL_FIRSTEVENT, SDL_LASTEVENT);
    begin();
}

RandomPlayer::~RandomPlayer() {
    app_.reset();
    std::error_code ignored;
    fs::current_path("/", ignored);
}

void RandomPlayer::begin() {
    window_.resize(anySize());
    std::vector<fs::path> mods;
    for (auto const& entry : fs::directory_iterator(folder_ / "mods")) {
        mods.push_back(entry.path());
    }
    std::sort(mods.begin(), mods.end());
    // The catalogue reads everything that a mod's levels need, which takes longer than many events.
    mods = {mods[below(mods.size())]};
    app_ = std::make_unique<GameApp>(window_, data_.registry, data_.parts,
                                     GameOptions{.levels = folder_ / "levels",
                                                 .pictures = folder_ / "pictures",
                                                 .profile = folder_ / "trembler" / "profile.json",
                                                 .world = {},
                                                 .steady = true,
                                                 .levelData = dataWithMods,
                                                 .mods = mods});
    app_->context().shadows = false;
    held_ = false;
    frame();
    beginSomewhere();
}

std::string RandomPlayer::beginSomewhere() {
    std::string what;
    switch (below(8)) {
    case 0:
        what = "title";
        app_->showTitle();
        break;
    case 1:
        what = "a page of the menu";
        app_->openMenu(static_cast<MenuPage>(1 + below(6)));
        break;
    case 2:
        what = "new level";
        app_->edit({});
        break;
    case 3:
    case 4: {
        fs::path const level = anyLevel();
        what = "edit " + level.filename().string();
        app_->edit(level);
        break;
    }
    default: {
        fs::path const level = anyLevel();
        what = "play " + level.filename().string();
        try {
            app_->open(level);
        } catch (InputError const&) { // after editing it is not a level any more
            what += ", which cannot be played";
        }
    }
    }
    frame();
    return what;
}

void RandomPlayer::end() {
    app_.reset();
}

std::string RandomPlayer::act() {
    struct Weighed {
        Act act;
        int weight;
    };
    static constexpr std::array<Weighed, 16> acts{{{&RandomPlayer::clickItem, 30},
                                                   {&RandomPlayer::clickAnywhere, 8},
                                                   {&RandomPlayer::moveAnywhere, 5},
                                                   {&RandomPlayer::pressOrRelease, 5},
                                                   {&RandomPlayer::drag, 10},
                                                   {&RandomPlayer::wheel, 4},
                                                   {&RandomPlayer::command, 25},
                                                   {&RandomPlayer::key, 14},
                                                   {&RandomPlayer::type, 6},
                                                   {&RandomPlayer::pad, 6},
                                                   {&RandomPlayer::wait, 10},
                                                   {&RandomPlayer::dropFile, 1},
                                                   {&RandomPlayer::resize, 1},
                                                   {&RandomPlayer::windowEvent, 2},
                                                   {&RandomPlayer::close, 1},
                                                   {&RandomPlayer::beginSomewhere, 1}}};
    std::size_t sum = 0;
    for (Weighed const& one : acts) {
        sum += static_cast<std::size_t>(one.weight);
    }
    auto left = static_cast<int>(below(sum));
    auto at = acts.begin();
    while (left >= at->weight) {
        left -= at->weight;
        ++at;
    }
    return (this->*at->act)();
}

render::Size RandomPlayer::anySize() {
    constexpr std::array<render::Size, 7> sizes{
        {{800, 450}, {1280, 720}, {800, 600}, {1024, 768}, {1920, 1080}, {640, 1136}, {2560, 1080}}};
    return sizes[below(sizes.size())];
}

Point RandomPlayer::anyPoint() {
    auto const& items = app_->context().layout.items();
    if (!items.empty() && oneIn(3)) {
        return items[below(items.size())].rect.middle();
    }
    render::Size const size = window_.size();
    return {static_cast<double>(below(static_cast<std::size_t>(size.width))),
            static_cast<double>(below(static_cast<std::size_t>(size.height)))};
}

fs::path RandomPlayer::anyLevel() {
    return levels_[below(levels_.size())];
}

void RandomPlayer::frame(double seconds) {
    ++pictures_;
    bool const going = app_->frame(seconds, pictures_ % drawnEvery == 0);
    for (Placed const& item : app_->context().layout.items()) {
        if (!std::isfinite(item.rect.low.x + item.rect.low.y + item.rect.high.x + item.rect.high.y)) {
            throw std::logic_error("\"" + item.name + "\" is nowhere on the screen");
        }
        seen_.insert(item.name);
    }
    for (Placed const& card : app_->context().layout.cards()) {
        seen_.insert(card.name);
    }
    keepInside();
    endFilm();
    if (!going) { // the player has quit; the next one begins
        app_.reset();
        begin();
    }
}

void RandomPlayer::endFilm() {
    constexpr int enough = 3; // pictures; each is a file of a megabyte, and nobody looks at them
    filmed_ = app_->screen().keepsPicture() ? filmed_ + 1 : 0;
    if (filmed_ > enough && app_->screen().commands().has("record")) {
        app_->screen().commands().run("record");
        filmed_ = 0;
    }
}

void RandomPlayer::keepInside() {
    SolutionsPage const& solutions = app_->menu().solutionsPage();
    if (app_->menu().page() == MenuPage::solutions && solutions.browsing() &&
        !solutions.browsed().string().starts_with(folder_.string())) {
        app_->openMenu(MenuPage::solutions); // without the list of files
    }
    auto* const editor = dynamic_cast<EditScreen*>(&app_->screen());
    if (editor == nullptr || !editor->parts().browser.isOpen()) {
        return;
    }
    FileBrowser& browser = editor->parts().browser;
    if (!browser.folder().string().starts_with(folder_.string())) {
        browser.begin(browser.purpose(), folder_ / "levels");
    }
}

std::vector<std::string> RandomPlayer::faultsOfFiles() const {
    std::vector<std::string> faults;
    for (auto const& entry : fs::recursive_directory_iterator(folder_)) {
        if (!entry.is_regular_file()) {
            continue;
        }
        fs::path const& path = entry.path();
        if (path.filename().string().ends_with(".part")) {
            faults.push_back(path.string() + ": half a file was left");
        }
        if (path.extension() == ".json") {
            try {
                static_cast<void>(JsonDocument::load(path));
            } catch (InputError const& error) {
                faults.emplace_back(error.what());
            }
        } else if (entry.file_size() == 0 && path.extension() != ".lock") {
            faults.push_back(path.string() + ": is empty");
        }
    }
    Profile const profile(folder_ / "trembler" / "profile.json");
    for (std::string const& trouble : profile.troubles()) {
        faults.push_back("profile.json: " + trouble);
    }
    return faults;
}

} // namespace trembler::ui::test
