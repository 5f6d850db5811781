#include "game/ui/play/play_parts.hpp"

#include "render/scene/areas.hpp"
#include "runtime/level/read/read_level.hpp"

namespace trembler::ui {

PlayParts::PlayParts(UiContext& uiContext, std::filesystem::path levelFile, WorldOptions const& options)
    : context(uiContext), file(std::move(levelFile)),
      session(context.registry, context.parts, loadLevel(context.registry, file), options),
      placing(session, context.toasts), hand(session), budget(context.registry), goals(session.level()),
      audio(context.loudspeaker), run(session, placing, hand, budget, audio, view, runEvents()),
      film(context.recorder, context.toasts), picking(session, inspector),
      mouse(session, placing, hand, view, picking) {
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
                    if (!celebration.noteStep(session)) {
                        return;
                    }
                    if (CatalogEntry const* const entry = context.levels.find(file)) {
                        context.profile.markSolved(entry->id);
                    }
                },
            .stopped =
                [this] {
                    celebration.reset();
                    film.end();
                }};
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

std::optional<TurnHandle> PlayParts::handle() const {
    return turnHandle(session, placing, context.catalog, pointer.pixel);
}

} // namespace trembler::ui
