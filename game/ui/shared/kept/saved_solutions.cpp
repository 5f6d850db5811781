#include "game/ui/shared/kept/saved_solutions.hpp"

#include "game/ui/shared/catalog/level_catalog.hpp"
#include "runtime/file/cut_text.hpp"
#include "runtime/file/folder_files.hpp"
#include "runtime/file/kept_file.hpp"
#include "runtime/file/output_file.hpp"
#include "runtime/file/visible_text.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/json/limits.hpp"
#include "runtime/level/write/write_level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <system_error>

namespace trembler::ui {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostShown = 1000; // solutions of one level

/// The name in a solution's text; empty if it is none.
std::string nameIn(std::string const& text) {
    try {
        auto const document = JsonDocument::parse(text, "solution");
        nlohmann::json const& root = document->root();
        auto const name = root.is_object() ? root.find("name") : root.end();
        return name != root.end() && name->is_string() ? name->get<std::string>() : std::string();
    } catch (InputError const&) {
        return {};
    }
}

/// What a solution's file says. Throws InputError.
nlohmann::json contentOf(fs::path const& file) {
    return JsonDocument::load(file)->root();
}

} // namespace

fs::path SavedSolutions::folderOf(std::string const& levelId) const {
    return folder_ / KeptBuilds(folder_).fileOf(levelId).stem();
}

std::vector<SavedSolution> SavedSolutions::of(std::string const& levelId) const {
    std::vector<SavedSolution> all;
    for (fs::path const& file : filesIn(folderOf(levelId), ".json", mostShown).files) {
        try {
            KeptText found = KeptFile(file).read();
            if (found.damaged) {
                damaged_.push_back(std::move(*found.damaged));
            }
            std::string name = found.text ? nameIn(*found.text) : std::string();
            if (!name.empty()) {
                all.push_back({file, cutText(std::move(name), limits::name)});
            }
        } catch (InputError const& error) { // it cannot be read now
            if (told_.insert(file).second) {
                notRead_.push_back(error);
            }
        }
    }
    std::sort(all.begin(), all.end(), [](SavedSolution const& a, SavedSolution const& b) {
        return naturallyBefore(a.file.filename().string(), b.file.filename().string());
    });
    return all;
}

fs::path SavedSolutions::save(std::string const& levelId, Solution const& solution) const {
    return writeNewFile(
        folderOf(levelId), [](int number) { return fmt::format("solution-{}.json", number); },
        escapedJson(writeSolution(solution).dump(2)) + "\n");
}

fs::path SavedSolutions::keep(std::string const& levelId, Solution const& solution) const {
    nlohmann::json const content = writeSolution(solution);
    for (SavedSolution const& saved : of(levelId)) {
        try {
            if (contentOf(saved.file) == content) {
                return saved.file;
            }
        } catch (InputError const&) {
            continue; // it was removed meanwhile
        }
    }
    return save(levelId, solution);
}

void SavedSolutions::rename(SavedSolution const& saved, std::string const& name) {
    KeptFile(saved.file).change([&](KeptText const& present) -> std::optional<std::string> {
        if (!present.text) {
            return std::nullopt; // it was removed meanwhile
        }
        auto content = nlohmann::ordered_json::parse(*present.text);
        content["name"] = name;
        return escapedJson(content.dump(2)) + "\n";
    });
}

void SavedSolutions::remove(SavedSolution const& saved) {
    KeptFile(saved.file).remove();
}

} // namespace trembler::ui
