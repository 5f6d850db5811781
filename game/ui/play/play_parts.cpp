#include "game/ui/play/play_parts.hpp"

#include "game/ui/cards/goal_counts.hpp"
#include "game/ui/play/view/level_extents.hpp"
#include "game/ui/play/whatif/what_if_tool.hpp"
#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "physics/dynamics/properties/crowd.hpp"
#include "puzzle/campaign/as_played.hpp"
#include "puzzle/checks/checked_level.hpp"
#include "render/scene/areas.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

namespace trembler::ui {

namespace {

/// By which the builds of a level are kept: that of the catalog, or the path of a level beyond it.
std::string buildId(LevelCatalog const& levels, std::filesystem::path const& file) {
    CatalogEntry const* const entry = levels.find(file);
    std::error_code ignored;
    return entry != nullptr ? entry->id : std::filesystem::weakly_canonical(file, ignored).generic_string();
}

Session sessionAt(std::filesystem::path const& file, Registry const& registry, PartLibrary const& parts,
                  WorldOptions const& options, LevelFile const* stated) {
    if (stated != nullptr) {
        return {registry, parts, *stated, options};
    }
    ReadyLevel ready = loadPlayable(registry, parts, file, options);
    ready.level = asPlayed(std::move(ready.level), "");
    return {registry, parts, std::move(ready)};
}

} // namespace

PlayParts::PlayParts(UiContext& uiContext, std::filesystem::path levelFile,
                     std::shared_ptr<GameData const> levelData, WorldOptions const& options,
                     LevelFile const* stated)
    : context(uiContext), file(std::move(levelFile)), id(buildId(context.levels, file)),
      ofGallery(context.levels.inGallery(file)), data(std::move(levelData)),
      modParts(data ? std::optional<PartCatalog>(std::in_place, data->parts, context.canvas) : std::nullopt),
      session(sessionAt(file, data ? data->registry : context.registry, data ? data->parts : context.parts,
                        options, stated)),
      placing(session, context.toasts), group(session, placing, context.toasts),
      wires(session, context.toasts), hand(session, context.toasts), secondHand(session, context.toasts, 1),
      budget(data ? data->registry : context.registry, context.stopwatch), goals(session.level()),
      timeline(data ? data->registry : context.registry, session),
      whatIf(std::make_shared<WhatIfView>(data ? data->registry : context.registry, session, timeline)),
      whatIfTool(std::make_shared<WhatIfTool>(timeline, *whatIf)),
      goalCounts(ui::goalCounts(session.level())), said(session),
      why(data ? data->registry : context.registry, data ? data->parts : context.parts, data, session, said),
      audio(context.loudspeaker), touches(context.loudspeaker),
      run(session, placing, hand, budget, audio, view, runEvents()),
      lesson(session, !context.profile.solved(id)), keeper(context.builds, id),
      film(context.recorder, context.toasts, context.pending),
      loadableSolutions(context.solutions, id, data ? data->registry : context.registry, session,
                        context.profile.progress(), [this](Solution const& solution) { load(solution); }),
      picking(session, inspector), mouse(session, placing, group, wires, hand, secondHand, view, picking),
      liveMods(data ? std::make_unique<LiveMods>(*data, session) : nullptr) {
    inspector.setScripts(data ? data->scripts.get() : nullptr);
    shown.names = context.profile.settings().names;
    if (int const leftOut = keeper.restore(session); leftOut > 0) {
        context.toasts.add(textWith("builds.changed", leftOut), render::ToastKind::News, 8);
    }
    newWorld();
    view.setSubject(subject());
    view.setLimits(subject());
    tellOfCrowd();
}

void PlayParts::tellOfCrowd() {
    Store const& store = session.world().store();
    if (auto const crowd = crowdedStart(store)) {
        context.toasts.add(translated(inWords(*crowd, store.nameOf(crowd->body))), render::ToastKind::News,
                           10);
    }
}

RunEvents PlayParts::runEvents() {
    return {.newWorld =
                [this] {
                    if (!run.building()) {
                        group.reset();
                        wires.reset();
                    }
                    newWorld();
                },
            .beforeStep =
                [this] {
                    if (session.world().frame() == 0) {
                        why.close(); // it was about another run
                    }
                    secondHand.beforeStep();
                    timeline.beforeStep();
                    scene.remember(session.world());
                    sounds.beforeStep(session.world());
                },
            .afterStep =
                [this] {
                    sounds.afterStep(session.world());
                    timeline.afterStep();
                    if (!context.profile.settings().reducedMotion) {
                        sparks.afterStep(session.world());
                    }
                    stepped();
                },
            .stopping = [this] { why.runEnds(); },
            .stopped =
                [this] {
                    timeline.stopped();
                    whatIf->forget();
                    whatIfTool->reset();
                    secondHand.reset();
                    sparks.reset();
                    cuts.reset();
                    celebration.reset();
                    reportedAltered_ = false;
                    film.end();
                },
            .slow =
                [this](SlowFrame const& slow) {
                    context.toasts.add(words::slowFrame(slow.frame, slow.seconds, slow.component),
                                       render::ToastKind::News, 8);
                }};
}

void PlayParts::stepped() {
    if (session.altered()) {
        if (session.solved() && !celebration.solvedAt() && !std::exchange(reportedAltered_, true)) {
            context.toasts.add(words::worksButAltered(*session.altered()), render::ToastKind::News, 6);
        }
        return;
    }
    if (!celebration.noteStep(session)) {
        return;
    }
    inspector.close(); // the card of success comes in their place
    why.close();
    if (CatalogEntry const* const entry = context.levels.find(file)) {
        solvedLevel(entry->id);
    }
}

void PlayParts::solvedLevel(std::string const& id) {
    context.profile.markSolved(id);
    if (session.whyNotRecorded() || ofGallery) {
        return; // only solutions of puzzles have kinds
    }
    context.kinds.look(id, data, data ? data->registry : context.registry, data ? data->parts : context.parts,
                       session.level(), session.record(id), session.world().frame());
}

void PlayParts::lookAtPast() {
    if (run.running()) {
        run.pauseOrGo();
    }
    hand.letGo();
    secondHand.letGo();
    timeline.setOpen(true);
}

void PlayParts::lookAt(std::uint64_t frame) {
    if (!run.building()) {
        lookAtPast();
        timeline.seek(frame);
    }
}

PadPhase PlayParts::phase() const {
    if (movesView) {
        return PadPhase::view;
    }
    if (session.mode() == SessionMode::building) {
        return PadPhase::building;
    }
    bool const past = whatIf->active() || (timeline.looksBack() && !timeline.playing());
    return past ? PadPhase::past : PadPhase::running;
}

void PlayParts::askWhy() {
    auto const selected = placing.selected();
    ObjectId object = picking.hovered();
    if (!object.valid()) {
        object = selected ? session.objectOf(*selected) : inspector.object(session);
    }
    if (object.valid() && !run.building()) {
        why.askObject(shownWorld().store().nameOf(object), timeline.frame());
    } else if (!session.judge().status().empty()) {
        why.askNextGoal();
    } else {
        context.toasts.add(text("Point at an object to ask why it is as it is."), render::ToastKind::News, 4);
    }
    inspector.close();
}

void PlayParts::continueHere() {
    if (!timeline.looksBack()) {
        return;
    }
    if (session.altered()) {
        context.toasts.add(
            text("A script was changed while it ran, so the run cannot be repeated up to this moment."),
            render::ToastKind::News, 6);
        return;
    }
    std::uint64_t const frame = timeline.frame();
    timeline.beginAgain();
    run.beginAgain(insight::playbackTo(session, frame), frame);
}

void PlayParts::keepBuild(double seconds) {
    keeper.pass(session, seconds);
}

void PlayParts::takeByKey(std::string const& part) {
    placing.cancel();
    group.reset();
    wires.reset();
    keyPointer.show(pointer, camera());
    Pointer at = pointer;
    at.world = keyPointer.at();
    placing.take(part, at);
    placing.keepInHand();
}

void PlayParts::passMods(double seconds) {
    if (liveMods == nullptr) {
        return;
    }
    if (why.working() || whatIf->active()) {
        // Other worlds run the same scripts, which may not change under them; messages from there are not of
        // this run.
        static_cast<void>(data->scriptLog->take());
        return;
    }
    auto const world = &session.world();
    liveMods->pass(seconds);
    for (ModMessage const& news : liveMods->takeNews()) {
        context.toasts.add(translated(news.text),
                           news.trouble ? render::ToastKind::Trouble : render::ToastKind::News,
                           news.trouble ? 10 : 4);
    }
    if (&session.world() != world) { // a script was replaced while building
        newWorld();
    }
}

void PlayParts::newWorld() {
    scene.start();
    goals.lookAt(session.world());
    picking.forget();
    said.newWorld();
}

void PlayParts::load(Solution const& solution) {
    run.stop();
    placing.reset();
    group.reset();
    wires.reset();
    inspector.close();
    why.close();
    session.load(solution);
    newWorld();
    context.toasts.add(textWith("solutions.loaded", solution.name), render::ToastKind::News, 5);
}

void PlayParts::restart() {
    run.stop();
    placing.reset();
    group.reset();
    wires.reset();
    inspector.close();
    why.close();
    session.putAllBack();
    hintsShown = hintAt = 0;
    hintsFolded = false;
    lesson.restart();
    newWorld();
}

void PlayParts::showHint() {
    std::size_t const total = said.hints().size();
    if (hintsHidden) { // what hides it has been read
        inspector.close();
        why.close();
        if (components.open()) {
            components.toggle();
        }
        modsPanel.setOpen(false);
        return;
    }
    if (hintsShown > 0 && hintsFolded) {
        hintsFolded = false;
        return;
    }
    hintsFolded = hintsShown > 0 && hintsShown >= total;
    hintsShown = std::min(hintsShown + 1, total);
    hintAt = hintsShown > 0 && !hintsFolded ? hintsShown - 1 : hintAt;
}

render::Extent PlayParts::subject() const {
    render::Extent all = focusOf(session);
    if (session.level().placing) {
        for (Area const& area : *session.level().placing) {
            all.add(render::extentOf(area));
        }
    }
    all.add(goals.extent());
    if (all.empty()) {
        all.add(render::Point{-2, -2});
        all.add(render::Point{2, 2});
    }
    return all.widened(0.06 * render::length(all.half()));
}

void PlayParts::showCut() {
    render::Link const wire = hand.takeCut();
    if (!wire.a.valid() || context.profile.settings().reducedMotion) {
        return;
    }
    World const& world = session.world();
    render::FactsReader const reader(world);
    cuts.add(render::cablePath(reader.of(wire.a), scene.poseOf(world, wire.a), reader.of(wire.b),
                               scene.poseOf(world, wire.b)));
}

std::optional<TurnHandle> PlayParts::handle() {
    return turnHandle(session, placing, catalog(), pointer.pixel, [this](Vec2 at) {
        return !context.layout.cardAt(camera().toScreen({at.x, at.y})).empty();
    });
}

} // namespace trembler::ui
