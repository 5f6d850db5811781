#include "game/ui/shared/catalog/level_catalog.hpp"

#include "game/ui/shared/shown_faults.hpp"
#include "game/ui/shared/texts.hpp"
#include "game/ui/shared/words.hpp"
#include "puzzle/campaign/chapter.hpp"
#include "runtime/file/cut_text.hpp"
#include "runtime/file/folder_files.hpp"
#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/read/folder_limits.hpp"
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

/// The data with which levels are read: loaded once for all levels of a folder that name the same mods.
class DataOfLevels {
public:
    DataOfLevels(Registry const& registry, CatalogMods const& mods) : registry_(registry), mods_(mods) {}
    [[nodiscard]] Registry const& registryOf(fs::path const& file) {
        std::vector<std::string> names = mods_.data ? lua::modsNamedBy(file) : std::vector<std::string>();
        if (names.empty()) {
            return registry_;
        }
        constexpr std::size_t most = 50;
        if (known_.size() >= most) { // the levels of a pack may name as many different sets of mods
            known_.clear();
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
    CatalogEntry entry{file, std::move(id), titleFromName(file.stem().string()), {}};
    try {
        LevelFile const level = loadLevel(data.registryOf(file), file);
        entry.demonstration = level.demonstration;
        entry.task = level.demonstration && !level.task.is_null();
        for (auto const& [language, texts] : level.texts) {
            entry.texts[language].title = texts.title; // the rest may be megabytes
        }
        if (!level.title.empty()) {
            entry.title = level.title;
        }
    } catch (std::exception const& error) {
        entry.trouble = troubleFrom(error);
    }
    return entry;
}

FolderFiles jsonBelow(fs::path const& folder) {
    FirstPaths files(limits::levelFiles);
    std::error_code failed;
    fs::recursive_directory_iterator walk(folder, fs::directory_options::skip_permission_denied, failed);
    for (; !failed && walk != fs::recursive_directory_iterator(); walk.increment(failed)) {
        auto const& path = walk->path();
        std::error_code error;
        if (walk->is_directory(error) && fs::exists(path / "mod.json", error)) {
            walk.disable_recursion_pending(); // a mod beside the levels of a pack: no level itself
            continue;
        }
        if (path.extension() == ".json" && !isNotALevel(path) && walk->is_regular_file(failed)) {
            files.add(path);
        }
    }
    return {.files = files.sorted(), .leftOut = files.leftOut(), .error = {}};
}

/// Says below a group that further levels are not listed.
void tellOf(std::size_t leftOut, CatalogGroup& group) {
    if (leftOut > 0) {
        group.text = textWith("levels.left_out", leftOut);
        group.texts.clear();
    }
}

/// A folder of levels, while the catalog is made.
struct Folder {
    std::string name; // below the folder of all levels; "." for that one itself
    Chapter chapter;
    std::vector<fs::path> const* files;
};

Chapter describe(fs::path const& levels, std::string const& name) {
    Chapter chapter;
    try {
        chapter = loadChapter(levels / name);
    } catch (InputError const& error) {
        chapter.title = titleFromName(fs::path(name).filename().string());
        chapter.text = error.diagnostics().front().print();
    }
    if (name == "." && chapter.title == ".") {
        chapter.title = words::looseLevels;
    }
    return chapter;
}

} // namespace

std::string troubleFrom(std::exception const& error) {
    constexpr std::size_t longest = 1000; // bytes
    auto const* const input = dynamic_cast<InputError const*>(&error);
    bool const fault = input != nullptr && !input->diagnostics().empty();
    return cutText(fault ? shownFault(input->diagnostics().front()) : shownError(error), longest);
}

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
    FolderFiles const all = jsonBelow(folder);
    for (fs::path const& file : all.files) {
        byFolder[file.parent_path().lexically_relative(folder).generic_string()].push_back(file);
    }
    std::vector<Folder> folders;
    for (auto& [name, files] : byFolder) {
        std::sort(files.begin(), files.end(), [](fs::path const& a, fs::path const& b) {
            return naturallyBefore(a.string(), b.string());
        });
        folders.push_back({name, describe(folder, name), &files});
    }
    std::stable_sort(folders.begin(), folders.end(), [](Folder const& a, Folder const& b) {
        return a.chapter.order != b.chapter.order ? a.chapter.order < b.chapter.order
                                                  : naturallyBefore(a.name, b.name);
    });
    for (Folder const& one : folders) {
        CatalogGroup group{one.chapter.title, one.chapter.text, one.chapter.kind == ChapterKind::gallery, {}};
        for (fs::path const& file : *one.files) {
            group.levels.push_back(entryFor(data, file, file.lexically_relative(folder).generic_string()));
        }
        group.texts = one.chapter.texts;
        groups_.push_back(std::move(group));
    }
    if (!groups_.empty()) {
        tellOf(all.leftOut, groups_.front());
    }
    for (fs::path const& mod : mods.mods) {
        std::string const name = mod.filename().string();
        CatalogGroup group{words::levelsOfMod(titleFromName(name)), {}, false, {}};
        FolderFiles found = jsonBelow(mod / "levels");
        std::vector<fs::path>& files = found.files;
        tellOf(found.leftOut, group);
        std::sort(files.begin(), files.end(), [](fs::path const& a, fs::path const& b) {
            return naturallyBefore(a.string(), b.string());
        });
        for (fs::path const& file : files) {
            group.levels.push_back(entryFor(
                data, file, "mods/" + name + "/" + file.lexically_relative(mod / "levels").generic_string()));
        }
        if (!group.levels.empty()) {
            groups_.push_back(std::move(group));
            ++ofMods_;
        }
    }
}

void LevelCatalog::noteTrouble(std::string const& id, std::string const& why) {
    for (CatalogGroup& group : groups_) {
        for (CatalogEntry& entry : group.levels) {
            if (entry.id == id) {
                entry.trouble = why;
            }
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

CatalogGroup const* LevelCatalog::groupOf(CatalogEntry const* entry) const {
    auto const found = std::find_if(groups_.begin(), groups_.end(), [&](CatalogGroup const& group) {
        return std::any_of(group.levels.begin(), group.levels.end(),
                           [&](CatalogEntry const& level) { return &level == entry; });
    });
    return found == groups_.end() ? nullptr : &*found;
}

CatalogEntry const* LevelCatalog::after(fs::path const& file) const {
    CatalogEntry const* const here = find(file);
    CatalogGroup const* const home = groupOf(here);
    bool passed = false;
    for (CatalogGroup const& group : groups_) {
        bool const related = home != nullptr && (home->gallery ? &group == home : !group.gallery);
        for (CatalogEntry const& entry : group.levels) {
            if (passed && related && entry.trouble.empty()) {
                return &entry;
            }
            passed = passed || &entry == here;
        }
    }
    return nullptr;
}

CatalogEntry const* LevelCatalog::next(CampaignProgress const& progress, fs::path const& file) const {
    CatalogEntry const* const here = file.empty() ? nullptr : find(file);
    if (CatalogGroup const* const home = groupOf(here); home != nullptr && home->gallery) {
        return after(file);
    }
    CatalogEntry const* first = nullptr; // of all that are not solved
    bool passed = here == nullptr;
    for (std::size_t i = 0; i + ofMods_ < groups_.size(); ++i) {
        for (CatalogEntry const& entry : groups_[i].levels) {
            bool const open = !groups_[i].gallery && entry.trouble.empty() && &entry != here &&
                              !progress.of(entry.id).solved;
            if (open && passed) {
                return &entry;
            }
            first = open && first == nullptr ? &entry : first;
            passed = passed || &entry == here;
        }
    }
    return first;
}

bool LevelCatalog::inGallery(fs::path const& file) const {
    CatalogGroup const* const home = groupOf(find(file));
    return home != nullptr && home->gallery;
}

StarCount LevelCatalog::stars(CampaignProgress const& progress) const {
    StarCount count;
    for (std::size_t i = 0; i + ofMods_ < groups_.size(); ++i) {
        for (CatalogEntry const& entry : groups_[i].levels) {
            if (groups_[i].gallery || !entry.trouble.empty()) {
                continue;
            }
            int const won = progress.of(entry.id).stars();
            count.won += won;
            count.missing += std::max(shownStars - won, 0);
        }
    }
    return count;
}

} // namespace trembler::ui
