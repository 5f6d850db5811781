// The scripts of a level that is played: their files, switches and parameters, and their messages.
#pragma once

#include "game/mods/file_watch.hpp"
#include "puzzle/data/game_data.hpp"
#include "puzzle/session/session.hpp"

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trembler {

/// An object that names a script, and the script's parameters for it.
struct ScriptUser {
    LastingObject object;
    std::string name;
    std::map<std::string, lua::Value>
        values; ///< by parameter: stated by the level or the part, or changed here
};

/// A script as the player sees it.
struct ModScript {
    std::shared_ptr<lua::LiveScript> live;
    lua::Mod const* mod = nullptr;
    std::map<std::string, lua::Value> defaults; ///< by parameter: changed here, for all that state none
    std::deque<std::string> log;                ///< the last lines that it wrote, the newest last
    std::optional<lua::ScriptMessage> failure;  ///< why it is switched off in this run
    std::vector<std::string> refused;           ///< the errors of the file as it was last saved
    int saved = 0;                              ///< how often another version took over
};

/// A message to the player.
struct ModMessage {
    std::string text;
    bool trouble = false;
};

/// Between the frames of one session. A script whose file is saved is replaced in the running world; if the
/// new version is wrong, the old one stays in use and the player gets a message. A run in which a script was
/// replaced, switched or given other parameters counts as no solution (Session::altered()); a later run
/// counts if the scripts are as their files say and the parameters as the level states them. Needs no window.
/// Not thread-safe.
class LiveMods {
public:
    /// Both must outlive it. Of game data without mods there is nothing to do.
    LiveMods(GameData const& gameData, Session& session);
    ~LiveMods();
    LiveMods(LiveMods const&) = delete;
    LiveMods& operator=(LiveMods const&) = delete;

    [[nodiscard]] std::vector<ModScript> const& scripts() const { return scripts_; }

    /// Collects the scripts' messages, and looks at their files when enough of `seconds` have passed.
    void pass(double seconds);
    /// Looks at the files now.
    void look();
    /// The messages since the last call, for the screen.
    [[nodiscard]] std::vector<ModMessage> takeNews();

    // `script` is a place in scripts().

    void setOn(std::size_t script, bool on);
    /// Sets a parameter for all objects that do not state it. Nothing happens if the value is no value for
    /// it.
    void setDefault(std::size_t script, std::string const& parameter, lua::Value const& value);
    /// Sets a parameter for one object that names the script.
    void setFor(std::size_t script, LastingObject const& object, std::string const& parameter,
                lua::Value const& value);
    /// Takes back all that was set for a script: its switch and its parameters.
    void asStated(std::size_t script);
    /// Whether anything of it was set that the level does not state.
    [[nodiscard]] bool changed(std::size_t script) const;
    /// The objects in the world that name the script, in order of their ids.
    [[nodiscard]] std::vector<ScriptUser> users(std::size_t script) const;

private:
    struct Tuned {
        std::size_t script = 0;
        LastingObject object;
        std::string parameter;
        lua::Value value;
        lua::Value stated; // the values in effect before
    };
    void collect();
    void reload(std::size_t script, FileWatch::Change const& change);
    /// Replaces a script in the world; nothing, or why no world can be built with it.
    [[nodiscard]] std::optional<std::string> put(std::size_t script, std::shared_ptr<lua::Script const> made);
    void worldBuilt();
    void wantReads();
    void apply(Tuned const& tuned);
    void tell(std::string text, bool trouble = false) { news_.push_back({std::move(text), trouble}); }

    GameData const& gameData_;
    Session& session_;
    std::vector<ModScript> scripts_;
    std::vector<std::shared_ptr<lua::Script const>>
        files_; // of each: as its file says, without other defaults
    std::unique_ptr<FileWatch> watch_;
    std::vector<Tuned> tuned_;
    std::vector<Subscription> reads_; // of versions that read more than the world was built for
    std::vector<ModMessage> news_;
    double sinceLook_ = 0; // s
};

} // namespace trembler
