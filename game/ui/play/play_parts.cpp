#include "game/ui/play/play_parts.hpp"

#include "game/ui/shared/words.hpp"
#include "render/scene/areas.hpp"
#include "runtime/level/read/read_level.hpp"

#include <utility>

namespace trembler::ui {

PlayParts::PlayParts(UiContext& uiContext, std::filesystem::path levelFile,
                     std::shared_ptr<GameData const> levelData, WorldOptions const& options,
                     LevelFile const* stated)
    : context(uiContext), file(std::move(levelFile)), data(std::move(levelData)),
      modParts(data ? std::optional<PartCatalog>(std::in_place, data->parts, context.canvas) : std::nullopt),
      session(data ? data->registry : context.registry, data ? data->parts : context.parts,
              stated != nullptr ? *stated : loadLevel(data ? data->registry : context.registry, file),
              options),
      placing(session, context.toasts), hand(session), budget(data ? data->registry : context.registry),
      goals(session.level()), audio(context.loudspeaker),
      run(session, placing, hand, budget, audio, view, runEvents()), film(context.recorder, context.toasts),
      picking(session, inspector), mouse(session, placing, hand, view, picking),
      workshop(data ? std::make_unique<Workshop>(*data, session) : nullptr) {
    inspector.setScripts(data ? data->scripts.get() : nullptr);
    shown.names = context.profile.settings().names;
    newWorld();
    view.setSubject(subject());
}

RunEvents PlayParts::runEvents() {
    return {.newWorld = [this] { newWorld(); },
            .beforeStep =
                [this] {
                    scene.remember(session.world());
                    sounds.beforeStep(session.world());
                },
            .afterStep =
                [this] {
                    sounds.afterStep(session.world());
                    stepped();
                },
            .stopped =
                [this] {
                    celebration.reset();
                    reportedAltered_ = false;
                    film.end();
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
    if (CatalogEntry const* const entry = context.levels.find(file)) {
        context.profile.markSolved(entry->id);
    }
}

void PlayParts::passMods(double seconds) {
    if (workshop == nullptr) {
        return;
    }
    auto const world = &session.world();
    workshop->pass(seconds);
    for (WorkshopNews const& news : workshop->takeNews()) {
        context.toasts.add(news.text, news.trouble ? render::ToastKind::Trouble : render::ToastKind::News,
                           news.trouble ? 10 : 4);
    }
    if (&session.world() != world) { // a script was replaced while building
        newWorld();
    }
}

void PlayParts::newWorld() {
    scene.start();
    picking.forget();
}

void PlayParts::restart() {
    run.stop();
    placing.reset();
    inspector.close();
    session.putAllBack();
    hintsShown = 0;
    newWorld();
    view.fit();
}

render::Extent PlayParts::subject() const {
    render::Extent all = render::sceneFocus(session.world());
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

std::optional<TurnHandle> PlayParts::handle() {
    return turnHandle(session, placing, catalog(), pointer.pixel);
}

} // namespace trembler::ui
