#include "game/ui/shared/kept/saved_solutions.hpp"

#include "game/ui/shared/catalog/level_catalog.hpp"
#include "runtime/file/cut_text.hpp"
#include "runtime/file/folder_files.hpp"
#include "runtime/file/output_file.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/json/limits.hpp"
#include "runtime/level/write/write_level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace trembler::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostShown = 1000; // solutions of one level

/// The name in a solution's file; empty if it is none.
std::string nameInFile(fs::path const& file) {
    try {
        auto const document = JsonDocument::load(file);
        nlohmann::json const& root = document->root();
        auto const name = root.is_object() ? root.find("name") : root.end();
        return name != root.end() && name->is_string() ? name->get<std::string>() : std::string();
    } catch (InputError const&) {
        return {};
    }
}

} // namespace

fs::path SavedSolutions::folderOf(std::string const& levelId) const {
    return folder_ / KeptBuilds(folder_).fileOf(levelId).stem();
}

std::vector<SavedSolution> SavedSolutions::of(std::string const& levelId) const {
    std::vector<SavedSolution> all;
    for (fs::path const& file : filesIn(folderOf(levelId), ".json", mostShown).files) {
        if (std::string name = nameInFile(file); !name.empty()) {
            all.push_back({file, cutText(std::move(name), limits::name)});
        }
    }
    std::sort(all.begin(), all.end(), [](SavedSolution const& a, SavedSolution const& b) {
        return naturallyBefore(a.file.filename().string(), b.file.filename().string());
    });
    return all;
}

fs::path SavedSolutions::save(std::string const& levelId, Solution const& solution) const {
    fs::path const folder = folderOf(levelId);
    std::error_code ignored; // writing the file reports it if that failed
    fs::create_directories(folder, ignored);
    for (int n = 1;; ++n) {
        fs::path file = folder / fmt::format("solution-{}.json", n);
        if (!fs::exists(file, ignored)) {
            writeFile(file, escapedJson(writeSolution(solution).dump(2)) + "\n");
            return file;
        }
    }
}

fs::path SavedSolutions::keep(std::string const& levelId, Solution const& solution) const {
    nlohmann::json const content = writeSolution(solution);
    for (SavedSolution const& saved : of(levelId)) {
        try {
            if (JsonDocument::load(saved.file)->root() == content) {
                return saved.file;
            }
        } catch (InputError const&) {
            continue; // it was removed meanwhile
        }
    }
    return save(levelId, solution);
}

void SavedSolutions::rename(SavedSolution const& saved, std::string const& name) {
    auto content = nlohmann::ordered_json::parse(JsonDocument::load(saved.file)->text());
    content["name"] = name;
    writeFile(saved.file, escapedJson(content.dump(2)) + "\n");
}

std::string SavedSolutions::remove(SavedSolution const& saved) {
    std::error_code failed;
    fs::remove(saved.file, failed);
    return failed ? failed.message() : std::string();
}

} // namespace trembler::ui
