#include "game/mods/file_watch.hpp"

#include <fstream>
#include <system_error>
#include <utility>

namespace trembler {

namespace fs = std::filesystem;

FileWatch::FileWatch(std::vector<fs::path> files, std::size_t mostBytes) : mostBytes_(mostBytes) {
    for (fs::path& path : files) {
        Stamp const stamp = stampOf(path);
        std::optional<std::string> text = textOf(path);
        files_.push_back({.path = std::move(path), .stamp = stamp, .text = std::move(text)});
    }
}

FileWatch::Stamp FileWatch::stampOf(fs::path const& path) {
    std::error_code error;
    Stamp stamp;
    stamp.time = fs::last_write_time(path, error);
    if (error) {
        return {};
    }
    stamp.size = fs::file_size(path, error);
    stamp.there = !error;
    return error ? Stamp{} : stamp;
}

std::optional<std::string> FileWatch::textOf(fs::path const& path) const {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        return std::nullopt;
    }
    std::string text(mostBytes_ + 1, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (file.bad()) {
        return std::nullopt;
    }
    text.resize(static_cast<std::size_t>(file.gcount()));
    return text;
}

std::vector<FileWatch::Change> FileWatch::look() {
    std::vector<Change> changes;
    for (std::size_t i = 0; i < files_.size(); ++i) {
        File& file = files_[i];
        Stamp const stamp = stampOf(file.path);
        if (stamp != file.stamp) {
            file.stamp = stamp;
            file.changing = true;
            continue;
        }
        if (!std::exchange(file.changing, false)) {
            continue;
        }
        std::optional<std::string> text = stamp.there ? textOf(file.path) : std::nullopt;
        if (text != file.text) {
            file.text = text;
            changes.push_back({i, std::move(text)});
        }
    }
    return changes;
}

} // namespace trembler
