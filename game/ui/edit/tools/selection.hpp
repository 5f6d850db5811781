// The designer's selection: objects by name, a piece of them, or one entry of another kind.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace trembler::ui {

/// A kind of entry besides objects.
enum class EntryKind : std::uint8_t { none, joint, connection, placing, goalArea };

/// Plain data. Names last when entries move in their lists, as undo and redo make them do.
class Selection {
public:
    [[nodiscard]] std::vector<std::string> const& objects() const { return objects_; }
    [[nodiscard]] bool has(std::string const& name) const {
        return std::find(objects_.begin(), objects_.end(), name) != objects_.end();
    }
    [[nodiscard]] bool empty() const { return objects_.empty() && kind_ == EntryKind::none; }

    void clear() {
        objects_.clear();
        kind_ = EntryKind::none;
        piece_.clear();
    }
    /// Selects these objects, and, if they were selected already, keeps the piece of them that was.
    void set(std::vector<std::string> names) {
        std::string piece = kind_ == EntryKind::none && names == objects_ ? piece_ : std::string();
        clear();
        objects_ = std::move(names);
        piece_ = std::move(piece);
    }
    void add(std::string const& name) {
        kind_ = EntryKind::none;
        piece_.clear();
        if (!has(name)) {
            objects_.push_back(name);
        }
    }
    void remove(std::string const& name) {
        std::erase(objects_, name);
        piece_.clear();
    }
    void rename(std::string const& from, std::string const& to) {
        std::replace(objects_.begin(), objects_.end(), from, to);
    }

    /// Of the selected objects, made from composite parts, the piece that is selected, as "pieces" of their
    /// entries states it; "": the objects themselves.
    [[nodiscard]] std::string const& piece() const { return piece_; }
    void choosePiece(std::string piece) { piece_ = std::move(piece); }

    /// Selects an entry that is no object; nothing else is selected then. `path` is its JSON pointer.
    void choose(EntryKind kind, std::string path) {
        clear();
        kind_ = kind;
        path_ = std::move(path);
    }
    [[nodiscard]] EntryKind kind() const { return kind_; }
    /// Of the entry, if kind() is not none.
    [[nodiscard]] std::string const& path() const { return path_; }

private:
    std::vector<std::string> objects_;
    std::string piece_;
    EntryKind kind_ = EntryKind::none;
    std::string path_;
};

} // namespace trembler::ui
