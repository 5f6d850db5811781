#include "game/ui/play/commands/command_sections.hpp"
#include "game/ui/shared/words.hpp"

namespace trembler::ui {
namespace {

using render::Icon;

CatalogEntry const* nextLevel(PlayParts const& parts) {
    return parts.context.levels.next(parts.context.profile.progress(), parts.file);
}

/// There is a way on from every level.
void openNext(PlayParts& parts) {
    switch (afterThis(parts)) {
    case AfterLevel::editor:
        parts.request = request::OpenMenu{MenuPage::main};
        break;
    case AfterLevel::gallery:
        parts.request = request::OpenMenu{MenuPage::gallery};
        break;
    case AfterLevel::end:
        parts.request = request::OpenMenu{MenuPage::ending};
        break;
    case AfterLevel::next:
        parts.request = request::OpenLevel{nextLevel(parts)->file};
        break;
    case AfterLevel::levels:
        parts.request = request::OpenMenu{MenuPage::levels};
        break;
    }
}

constexpr Command<PlayParts> levelTable[] = {
    {.info = {.id = "restart",
              .icon = Icon::Repeat,
              .group = CommandGroup::building,
              .name = words::restart,
              .tip = "Put all parts back and forget the hints: the level as it was opened",
              .help = "start the level again"},
     .run = [](PlayParts& parts) { parts.restart(); }},
    {.info = {.id = "next-level",
              .icon = Icon::Next,
              .group = CommandGroup::program,
              .name = words::nextLevel,
              .tip = "Open the next level",
              .help = "next level"},
     .run = openNext},
    {.info = {.id = "watch-again",
              .icon = Icon::Play,
              .group = CommandGroup::running,
              .name = words::watchAgain,
              .tip = "Watch this run again from its beginning",
              .help = "watch again"},
     .run = [](PlayParts& parts) { parts.run.watchAgain(); },
     .available = inARun},
    {.info = {.id = "keep-playing",
              .group = CommandGroup::running,
              .name = words::keepPlaying,
              .tip = "Close the card and keep playing",
              .help = "keep playing"},
     .run =
         [](PlayParts& parts) {
             parts.celebration.dismiss();
             parts.run.takeOver(); // the hand is the player's again, also in a run that was watched
         },
     .available = [](PlayParts const& parts) { return parts.celebration.showing(); }},
};

} // namespace

AfterLevel afterThis(PlayParts const& parts) {
    LevelCatalog const& levels = parts.context.levels;
    if (parts.testPlay) {
        return AfterLevel::editor;
    }
    if (nextLevel(parts) != nullptr) {
        return AfterLevel::next;
    }
    if (levels.find(parts.file) == nullptr) {
        return AfterLevel::levels;
    }
    return parts.ofGallery ? AfterLevel::gallery : AfterLevel::end;
}

std::span<Command<PlayParts> const> levelCommands() {
    return levelTable;
}

} // namespace trembler::ui
