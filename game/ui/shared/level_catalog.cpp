#include "game/ui/shared/level_catalog.hpp"

#include "game/ui/shared/words.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/read/read_level.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <system_error>
#include <utility>

namespace trembler::ui {
namespace {

namespace fs = std::filesystem;

bool isDigit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// "2-first-contact" becomes "First contact".
std::string titleFrom(std::string name) {
    std::size_t start = 0;
    while (start < name.size() && (isDigit(name[start]) || name[start] == '-')) {
        ++start;
    }
    name = start < name.size() ? name.substr(start) : name;
    std::replace(name.begin(), name.end(), '-', ' ');
    std::replace(name.begin(), name.end(), '_', ' ');
    if (!name.empty()) {
        name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    }
    return name;
}

/// What levels are read with: loaded once for all in a folder that name the same mods.
class DataOfLevels {
public:
    DataOfLevels(Registry const& registry, CatalogMods const& mods) : registry_(registry), mods_(mods) {}
    [[nodiscard]] Registry const& registryOf(fs::path const& file) {
        std::vector<std::string> names = mods_.data ? lua::modsNamedBy(file) : std::vector<std::string>();
        if (names.empty()) {
            return registry_;
        }
        auto& data = known_[{file.parent_path(), std::move(names)}];
        if (data == nullptr) {
            data = mods_.data(file);
        }
        return data == nullptr ? registry_ : data->registry;
    }

private:
    Registry const& registry_;
    CatalogMods const& mods_;
    std::map<std::pair<fs::path, std::vector<std::string>>, std::shared_ptr<GameData const>> known_;
};

CatalogEntry entryFor(DataOfLevels& data, fs::path const& file, std::string id) {
    CatalogEntry entry{file, std::move(id), titleFrom(file.stem().string()), {}};
    try {
        LevelFile const level = loadLevel(data.registryOf(file), file);
        if (!level.title.empty()) {
            entry.title = level.title;
        }
    } catch (InputError const& error) {
        entry.trouble =
            error.diagnostics().empty() ? std::string(error.what()) : error.diagnostics().front().print();
    } catch (std::exception const& error) {
        entry.trouble = error.what();
    }
    return entry;
}

std::vector<fs::path> jsonBelow(fs::path const& folder) {
    std::vector<fs::path> files;
    std::error_code failed;
    fs::recursive_directory_iterator walk(folder, fs::directory_options::skip_permission_denied, failed);
    for (; !failed && walk != fs::recursive_directory_iterator(); walk.increment(failed)) {
        auto const& path = walk->path();
        std::error_code error;
        if (walk->is_directory(error) && fs::exists(path / "mod.json", error)) {
            walk.disable_recursion_pending(); // a mod beside the levels of a pack: no level itself
            continue;
        }
        bool const schema = path.stem().extension() == ".schema" || path.stem() == "schema";
        if (path.extension() == ".json" && !schema && walk->is_regular_file(failed)) {
            files.push_back(path);
        }
    }
    return files;
}

} // namespace

bool naturallyBefore(std::string_view a, std::string_view b) {
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() && j < b.size()) {
        if (isDigit(a[i]) && isDigit(b[j])) {
            auto const number = [](std::string_view text, std::size_t& at) {
                while (at < text.size() && text[at] == '0') {
                    ++at;
                }
                std::size_t const start = at;
                while (at < text.size() && isDigit(text[at])) {
                    ++at;
                }
                return text.substr(start, at - start);
            };
            std::string_view const x = number(a, i);
            std::string_view const y = number(b, j);
            if (x.size() != y.size()) {
                return x.size() < y.size();
            }
            if (x != y) {
                return x < y;
            }
        } else if (a[i] != b[j]) {
            return a[i] < b[j];
        } else {
            ++i;
            ++j;
        }
    }
    return a.size() - i < b.size() - j;
}

LevelCatalog::LevelCatalog(Registry const& registry, fs::path const& folder, CatalogMods const& mods) {
    DataOfLevels data(registry, mods);
    std::map<std::string, std::vector<fs::path>> byFolder;
    for (fs::path const& file : jsonBelow(folder)) {
        byFolder[file.parent_path().lexically_relative(folder).generic_string()].push_back(file);
    }
    std::vector<std::string> names;
    for (auto& [name, files] : byFolder) {
        names.push_back(name);
        std::sort(files.begin(), files.end(), [](fs::path const& a, fs::path const& b) {
            return naturallyBefore(a.string(), b.string());
        });
    }
    std::stable_sort(names.begin(), names.end(), [](std::string const& a, std::string const& b) {
        bool const firstA = a == "first";
        bool const firstB = b == "first";
        return firstA != firstB ? firstA : naturallyBefore(a, b);
    });
    for (std::string const& name : names) {
        CatalogGroup group{name == "." ? std::string(words::looseLevels)
                                       : titleFrom(fs::path(name).filename().string()),
                           {}};
        if (name == "first") {
            group.title = words::firstSteps;
        }
        for (fs::path const& file : byFolder[name]) {
            group.levels.push_back(entryFor(data, file, file.lexically_relative(folder).generic_string()));
        }
        groups_.push_back(std::move(group));
    }
    for (fs::path const& mod : mods.mods) {
        std::string const name = mod.filename().string();
        CatalogGroup group{words::levelsOfMod(titleFrom(name)), {}};
        std::vector<fs::path> files = jsonBelow(mod / "levels");
        std::sort(files.begin(), files.end(), [](fs::path const& a, fs::path const& b) {
            return naturallyBefore(a.string(), b.string());
        });
        for (fs::path const& file : files) {
            group.levels.push_back(entryFor(
                data, file, "mods/" + name + "/" + file.lexically_relative(mod / "levels").generic_string()));
        }
        if (!group.levels.empty()) {
            groups_.push_back(std::move(group));
        }
    }
}

std::size_t LevelCatalog::size() const {
    std::size_t count = 0;
    for (CatalogGroup const& group : groups_) {
        count += group.levels.size();
    }
    return count;
}

CatalogEntry const* LevelCatalog::find(fs::path const& file) const {
    std::error_code ignored;
    for (CatalogGroup const& group : groups_) {
        for (CatalogEntry const& entry : group.levels) {
            if (fs::equivalent(entry.file, file, ignored)) {
                return &entry;
            }
        }
    }
    return nullptr;
}

CatalogEntry const* LevelCatalog::after(fs::path const& file) const {
    CatalogEntry const* const here = find(file);
    bool passed = false;
    for (CatalogGroup const& group : groups_) {
        for (CatalogEntry const& entry : group.levels) {
            if (passed && entry.trouble.empty()) {
                return &entry;
            }
            passed = passed || &entry == here;
        }
    }
    return nullptr;
}

} // namespace trembler::ui
