// A level that is being edited: its tree, its text, its file, and the history of its changes.
#pragma once

#include "puzzle/data/game_data.hpp"
#include "puzzle/edit/document/command.hpp"
#include "puzzle/edit/document/tree_patch.hpp"
#include "puzzle/edit/text/source_text.hpp"
#include "runtime/file/output_file.hpp"
#include "runtime/level/model/level.hpp"

#include <cstddef>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trembler::edit {

/// How saving went.
struct SaveResult {
    enum class Kind {
        saved,
        /// Another program changed the file since it was opened or saved last, or another file of that name
        /// exists; nothing was written. Ask the author, then save with Overwrite::yes or elsewhere.
        conflict,
        failed, ///< nothing was written; the file is as it was
    };
    Kind kind = Kind::saved;
    std::string message{};              ///< for people, for a conflict or a failure
    std::optional<OutputError> error{}; ///< of a failure to write

    [[nodiscard]] bool ok() const { return kind == Kind::saved; }
};

/// The document is the file as its author wrote it: a tree that keeps the order of all entries. Only entries
/// that commands change differ in the text that is saved; all else keeps its spelling and its line breaks.
/// Not thread-safe.
class LevelDocument {
public:
    enum class Overwrite { no, yes };
    /// Of memory for the history. Beyond it the oldest steps are forgotten, but for the last few.
    static constexpr std::size_t mostHistory = std::size_t{256} << 20U;
    static constexpr std::size_t fewestSteps = 3;

    /// A new level without a file: a floor, gravity and bounds, no goals. `data` must outlive every document.
    [[nodiscard]] static LevelDocument blank(GameData const& data);
    /// Opens a level file. Throws InputError if it cannot be read at all: it does not exist, is a folder, is
    /// too large, or may not be read. A file that is no JSON, has errors, or was made by a newer version of
    /// the program opens read-only; faults() lists its errors. A file of an older version is converted; it is
    /// saved in the present version.
    [[nodiscard]] static LevelDocument open(GameData const& data, std::filesystem::path const& path);
    /// A document with this text, as if it had been edited: for recovery. `path` is the file to which it will
    /// be saved, empty if it has none; `onDisk` is that file's text when it was opened last. Throws
    /// InputError for a text that is not JSON.
    [[nodiscard]] static LevelDocument fromText(GameData const& data, std::string const& text,
                                                std::filesystem::path path,
                                                std::optional<std::string> onDisk);

    [[nodiscard]] GameData const& data() const { return *data_; }
    /// Reads the document with these data from now on; they must outlive it.
    void setData(GameData const& data) { data_ = &data; }
    /// The level; null if the file is no JSON.
    [[nodiscard]] Json const& tree() const { return tree_; }
    /// The file as save() would write it. Made on first use after a change.
    [[nodiscard]] std::string const& text() const;
    /// Empty for a new level that has not been saved.
    [[nodiscard]] std::filesystem::path const& path() const { return path_; }
    /// For people: the file's path as GameData::shortName() has it, or "new level".
    [[nodiscard]] std::string name() const;

    // Read-only documents.

    /// Whether commands are refused, because the file was opened with faults.
    [[nodiscard]] bool readOnly() const { return readOnly_; }
    /// The problems of the file when it was opened.
    [[nodiscard]] std::vector<Diagnostic> const& faults() const { return faults_; }
    /// Whether the author may decide to edit it nevertheless: the file is a JSON object of a version that
    /// this program knows. Editing keeps entries that the program does not understand.
    [[nodiscard]] bool mayBeEdited() const;
    /// Ends read-only. Throws CommandError unless mayBeEdited().
    void editNevertheless();

    // Changing.

    /// Runs a command and adds it to the history; steps that were undone can then no longer be redone. A
    /// command that changes nothing adds no step. With a gesture, it becomes one step with the previous
    /// command if that has the same gesture. Throws CommandError, with the document as it was, if it is
    /// read-only, or the command cannot be run.
    void run(Command const& command, std::optional<Gesture> gesture = {});
    /// A number that no other gesture of this document has.
    [[nodiscard]] std::uint64_t newGesture() { return ++lastGesture_; }
    [[nodiscard]] bool canUndo() const { return done_ > 0; }
    [[nodiscard]] bool canRedo() const { return done_ < steps_.size(); }
    /// The number of steps that are done, without those that were undone; those that were forgotten count.
    [[nodiscard]] std::size_t done() const { return forgotten_ + done_; }
    /// Forgets the oldest steps until the rest takes so many bytes of memory, or only the last few are left;
    /// run() does it with mostHistory.
    void shortenHistory(std::size_t most);
    /// The name of the step that undo() or redo() is about; empty if there is none.
    [[nodiscard]] std::string undoName() const;
    [[nodiscard]] std::string redoName() const;
    /// False if there is nothing to undo or redo.
    bool undo();
    bool redo();
    /// Undoes or redoes until done() is `count`, as far as steps are known.
    void goTo(std::size_t count);
    /// Differs after every change of the tree, undo and redo included. For caches.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }
    /// Whether the tree differs from the one that was opened or saved last, according to the history: undoing
    /// to the state that was saved makes it false.
    [[nodiscard]] bool modified() const { return state() != savedState_; }

    // Reading it as a level.

    /// The level for a session: the document as the rest of the program would read it from the file. Throws
    /// InputError with all problems of reading. A session has its own copy, so playing changes nothing here.
    [[nodiscard]] LevelFile level() const;
    /// The parsed text with the name of the file, for places of problems. Throws InputError only for a file
    /// that is no JSON or is too large.
    [[nodiscard]] std::shared_ptr<JsonDocument const> const& json() const;

    // Saving.

    /// Writes the file as KeptFile does: completely or not at all, with the version before it as FILE~. A
    /// file that another program changed since it was opened is not overwritten unless `overwrite` is yes;
    /// one that is no JSON is moved aside then. A new level fails: it has no path. A read-only document
    /// fails.
    [[nodiscard]] SaveResult save(Overwrite overwrite = Overwrite::no);
    /// Saves to another file, which becomes the document's. Makes no folders. A read-only document may be
    /// saved elsewhere: its text is copied.
    [[nodiscard]] SaveResult saveAs(std::filesystem::path const& path, Overwrite overwrite = Overwrite::no);
    /// The text of the file when it was opened or saved last; nothing for a new level.
    [[nodiscard]] std::optional<std::string> const& onDisk() const { return onDisk_; }

private:
    struct Step {
        std::string name;
        TreePatch patch;
        std::uint64_t state;   // a number for the tree after it
        std::uint64_t gesture; // 0: none
        std::size_t bytes;     // of memory
    };
    LevelDocument(GameData const& data, std::string text, std::filesystem::path path);

    void parse(std::string const& file);
    void convert();
    void changed();
    /// May throw, having changed the tree or not.
    void changeTree(Command const& command);
    void forgetStepsFrom(std::size_t first);
    [[nodiscard]] std::uint64_t state() const { return done_ == 0 ? firstState_ : steps_[done_ - 1].state; }
    [[nodiscard]] SaveResult write(std::filesystem::path const& path, Overwrite overwrite);

    GameData const* data_;
    std::shared_ptr<SourceText const> source_; // the text as it was opened; never changes
    Json tree_;
    std::filesystem::path path_;
    std::optional<std::string> onDisk_;
    bool readOnly_ = false;
    std::vector<Diagnostic> faults_;
    std::deque<Step> steps_;
    std::size_t done_ = 0;
    std::size_t forgotten_ = 0;    // steps before the first one
    std::size_t stepBytes_ = 0;    // of all steps
    std::uint64_t firstState_ = 0; // before the first one
    std::uint64_t lastState_ = 0;
    std::uint64_t savedState_ = 0;
    std::uint64_t lastGesture_ = 0;
    bool gestureOpen_ = false; // whether a command may still join the last step
    Json before_;              // the tree before the last step, while a command may join it
    std::uint64_t revision_ = 0;
    mutable std::optional<std::string> text_;          // of tree_
    mutable std::shared_ptr<JsonDocument const> json_; // of text_
};

} // namespace trembler::edit
