#include "game/ui/edit/edit_parts.hpp"

#include "audio/device/loudspeaker.hpp"
#include "game/ui/edit/edit_words.hpp"
#include "game/ui/edit/study/level_studies.hpp"
#include "game/ui/shared/kept/damaged_parts.hpp"
#include "game/ui/shared/shown_faults.hpp"
#include "puzzle/edit/commands/editor_state.hpp"
#include "puzzle/edit/commands/objects.hpp"
#include "render/scene/areas.hpp"
#include "runtime/level/read/read_level.hpp"

#include <algorithm>
#include <ctime>
#include <set>
#include <system_error>
#include <utility>

namespace trembler::ui {
namespace {

/// The problems of a level are looked for when the designer pauses for this time, s.
constexpr double pauseBeforeChecking = 0.25;
/// A level that takes longer to be read, s, is read when the changes pause.
constexpr double quickRead = 0.004;
constexpr double pauseBeforeReading = 0.1; // s
/// At once if the last check took less than this, s, and nothing is being dragged: a step of a drag already
/// builds the world.
constexpr double quickCheck = 0.004;

/// Whether a level's file is damaged, and its last good version is there.
bool hasLastGood(std::filesystem::path const& level) {
    try {
        KeptText const found = level.empty() ? KeptText{} : KeptFile(level).look();
        return found.damaged && found.damaged->lastTaken;
    } catch (InputError const&) {
        return false;
    }
}

} // namespace

EditParts::EditParts(UiContext& uiContext, EditOptions editOptions)
    : context(uiContext), options(std::move(editOptions)), data(options.data),
      document(edit::LevelDocument::blank(*data)), studies(std::make_shared<LevelStudies>()), plain_(data) {
    dataParts.emplace(data->parts, context.canvas);
    autosave = std::make_unique<edit::Autosave>(options.recovery);
    names = context.profile.settings().names;
    read();
    setViewSubject();
}

bool EditParts::run(std::function<edit::Command(edit::Json const&)> const& make,
                    std::optional<edit::Gesture> gesture) {
    try {
        edit::Command const command = make(document.tree());
        auto const objects = [&] { return tree().contains("objects") ? tree()["objects"].size() : 0; };
        std::size_t const before = objects();
        document.run(command, gesture);
        if (objects() > before && context.loudspeaker != nullptr) {
            context.loudspeaker->touch(InterfaceSound::place);
        }
        if (!command.selects.empty()) {
            selection.set(command.selects);
        }
        sinceChange_ = 0;
        return true;
    } catch (edit::CommandError const& error) {
        tell(shownError(error), render::ToastKind::Trouble);
        return false;
    }
}

void EditParts::tell(std::string text, render::ToastKind kind) {
    context.toasts.add(std::move(text), kind, kind == render::ToastKind::Trouble ? 6 : 4);
}

void EditParts::use(edit::LevelDocument next, std::shared_ptr<GameData const> nextData) {
    autosave->close();
    context.pending.forget(Owned::unsavedLevel);
    autosave = std::make_unique<edit::Autosave>(options.recovery);
    document = std::move(next);
    setData(std::move(nextData));
    problems = {};
    selection.clear();
    dialogs.propose({});
    partInHand.clear();
    goalChosen = false;
    goalTree = playedTree = edit::GoalTree::goals;
    translation.clear();
    limitedCounts.clear();
    goals.forget();
    studies->forget();
    tool = Tool::select;
    readRevision_.reset();
    read();
    problems.refresh(document);
    setViewSubject();
    view.fit();
    if (document.readOnly()) {
        dialogs.showReadOnly(hasLastGood(document.path()));
    }
}

void EditParts::setData(std::shared_ptr<GameData const> next) {
    former_ = std::exchange(data, std::move(next));
    about = {};
    inspected = {};
    dataParts.emplace(data->parts, context.canvas);
}

void EditParts::reloadParts() {
    try {
        plain_ = std::make_shared<GameData const>();
    } catch (InputError const& error) {
        return tell(shownError(error), render::ToastKind::Trouble);
    }
    for (std::string& sentence : moveDamagedAside(plain_->damagedOwnParts)) {
        tell(std::move(sentence), render::ToastKind::Trouble);
    }
    if (options.partsMade) {
        options.partsMade(plain_);
    }
    setData(dataFor(document.path()));
    document.setData(*data);
    problems = {};
    goals.forget();
    readRevision_.reset();
    read();
    problems.refresh(document);
}

void EditParts::openFile(std::filesystem::path const& path) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) {
        newLevel();
        dialogs.propose(path);
        return;
    }
    try {
        auto const own = dataFor(path);
        use(edit::LevelDocument::open(*own, path), own);
    } catch (std::exception const& error) {
        tell(shownError(error), render::ToastKind::Trouble);
    }
}

void EditParts::takeLastGood() {
    std::filesystem::path const path = document.path();
    try {
        KeptText found = KeptFile(path).read();
        if (found.damaged) {
            tell(inWords(*found.damaged), render::ToastKind::Trouble);
        }
        if (!found.text || found.inPlace() || (found.damaged && !found.damaged->stays)) {
            return openFile(path);
        }
        // The damaged file cannot be moved away: saving will say so.
        auto const own = dataFor(path);
        use(edit::LevelDocument::fromText(*own, *found.text, path, std::nullopt), own);
    } catch (InputError const& error) {
        tell(shownError(error), render::ToastKind::Trouble);
    }
}

std::shared_ptr<GameData const> EditParts::dataFor(std::filesystem::path const& path) {
    try {
        if (auto const withMods = options.levelData && !path.empty() ? options.levelData(path) : nullptr) {
            return withMods;
        }
    } catch (std::exception const& error) { // a mod is missing or wrong: the level can still be edited
        tell(shownError(error), render::ToastKind::Trouble);
    }
    return plain_;
}

void EditParts::newLevel() {
    use(edit::LevelDocument::blank(*plain_), plain_);
}

void EditParts::read() {
    if (readRevision_ == document.revision()) {
        return;
    }
    std::clock_t const begun = std::clock(); // not the time of day: the machine may be busy
    readRevision_ = seenRevision_ = document.revision();
    sinceRead_ = 0;
    try {
        Problems faults; // shown by the list of problems
        LevelFile now = readLevel(data->registry, document.json(), faults);
        level = std::move(now);
    } catch (InputError const&) { // no JSON, or too large: the shown world stays
    }
    LevelFile shown = level;
    std::erase_if(shown.objects,
                  [&](LevelObject const& object) { return edit::isHidden(document.tree(), object.name); });
    world.build(*data, shown, document.tree());
    scene.start();
    std::vector<std::string> const all = edit::objectNames(document.tree());
    std::set<std::string> const there(all.begin(), all.end());
    for (std::string const& name : std::vector<std::string>(selection.objects())) {
        if (!there.contains(name)) {
            selection.remove(name);
        }
    }
    setViewSubject();
    readTook_ = static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
}

void EditParts::followChanges(bool dragging) {
    bool const changed = std::exchange(seenRevision_, document.revision()) != document.revision();
    bool const soonAgain = dragging || readTook_ > quickRead;
    if (soonAgain && sinceChange_ < pauseBeforeReading) {
        if (!changed || world.follow(document.tree())) {
            return;
        }
        if (readTook_ > quickRead && sinceRead_ < pauseBeforeReading) {
            return; // a change that the world cannot follow is shown a little later
        }
    }
    read();
}

void EditParts::follow(double seconds, bool dragging) {
    sinceChange_ = seenRevision_ == document.revision() ? sinceChange_ + seconds : 0;
    sinceRead_ += seconds;
    if (readRevision_ != document.revision()) {
        followChanges(dragging);
    }
    bool const current = readRevision_ == document.revision();
    bool const quick = !dragging && problems.lastSeconds() < quickCheck;
    if (current && (sinceChange_ > pauseBeforeChecking || quick)) {
        problems.refresh(document);
    }
    autosave->tick(document, seconds);
    context.pending.look(Owned::unsavedLevel, autosave->error());
}

void EditParts::setViewSubject() {
    render::Extent const all = extent();
    view.setSubject(all);
    // A window around it that shows all of it: there new objects can be drawn, and the level is found again.
    view.setLimits(all.widened(2 * std::max(all.half().x, all.half().y)));
}

render::Extent EditParts::extent() const {
    render::Extent all;
    if (world.world() != nullptr) {
        all = render::sceneFocus(*world.world());
    }
    for (Area const& area : level.placing.value_or(std::vector<Area>())) {
        all.add(render::extentOf(area));
    }
    if (level.bounds) {
        all.add(render::extentOf(Area{level.bounds, {}}));
    }
    if (all.empty()) {
        all.add(render::Point{-4, -1});
        all.add(render::Point{4, 4});
    }
    return all.widened(0.06 * render::length(all.half()));
}

Vec2 EditParts::middleOfView() const {
    render::Size const size = camera().viewport;
    // Left of the panel, which covers the right of the window.
    render::Point const at = camera().toWorld({0.38 * size.width, 0.5 * size.height});
    return snapping.place({at.x, at.y});
}

} // namespace trembler::ui
