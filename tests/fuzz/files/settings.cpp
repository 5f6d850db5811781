#include "game/ui/app/command_lists.hpp"
#include "game/ui/shared/commands/key_bindings.hpp"
#include "game/ui/shared/kept/profile.hpp"
#include "tests/fuzz/files/kit.hpp"
#include "tests/fuzz/play.hpp"
#include "tests/fuzz/targets.hpp"

namespace trembler::files {
namespace {

void requireRanges(ui::Settings const& settings) {
    lua::require(settings.uiScale >= 0.5F && settings.uiScale <= 3.F, "the interface has no size");
    for (int const percent : {settings.volume, settings.touches}) {
        lua::require(percent >= 0 && percent <= 100, "a volume is no percentage");
    }
}

} // namespace

void fuzzSettings(std::string_view bytes) {
    // Without what an earlier input has left behind: a last good version, damaged ones.
    std::filesystem::path const folder = ownFolder() / "profile";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::filesystem::path const file = folder / "profile.json";
    write(file, bytes);
    bool const whole = ui::isWholeProfile(bytes);
    ui::Profile profile(file);
    for (std::string const& trouble : profile.troubles()) {
        lua::require(!trouble.empty(), "a problem says nothing");
    }
    lua::require(std::filesystem::exists(folder / "profile.json.damaged-1") != whole,
                 "a damaged file is not kept aside");
    requireRanges(profile.settings());
    ui::KeyBindings keys(ui::commandLists());
    for (std::string const& trouble : keys.load(profile.keys())) {
        lua::require(!trouble.empty(), "a problem says nothing");
    }
    for (ui::CommandInfo const* const info : keys.commands()) {
        for (ui::Chord const& chord : keys.keysOf(info->id)) {
            lua::require(ui::chordFrom(ui::nameOf(chord)) == chord, "a key has no name");
        }
    }
    // Written settings are read unchanged, and bound in the same way.
    profile.setKeys(keys.stated());
    profile.markSolved("first/1-first-contact.json");
    ui::Profile const again(file);
    lua::require(profile.settings() == again.settings(), "settings change when they are saved");
    lua::require(again.keys() == keys.stated(), "keys change when they are saved");
    lua::require(again.progress().written() == profile.progress().written(),
                 "progress changes when it is saved");
    ui::KeyBindings other(ui::commandLists());
    lua::require(other.load(again.keys()).empty(), "keys that were saved cannot be loaded");
}

} // namespace trembler::files
