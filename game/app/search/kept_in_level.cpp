#include "game/app/search/kept_in_level.hpp"

#include "insight/search/recorded.hpp"
#include "puzzle/edit/commands/solutions.hpp"
#include "runtime/file/output_file.hpp"

#include <fmt/format.h>

namespace trembler {
namespace {

[[noreturn]] void refuse(std::filesystem::path const& file, std::string const& why) {
    throw OutputError(fmt::format("--add-to-level: {}: nothing can be added: {}", file.string(), why));
}

} // namespace

KeptInLevel::KeptInLevel(GameData const& data, std::filesystem::path const& file)
    : document_(edit::LevelDocument::open(data, file)) {
    if (document_.readOnly()) {
        refuse(file, document_.faults().empty() ? "the file has errors, or is from a newer version"
                                                : document_.faults().front().print());
    }
    OutputFile const probe(file); // throws if it must not be written; without commit() nothing is
}

std::string KeptInLevel::add(insight::FoundSolution const& found, std::size_t number) {
    Solution const solution = insight::solutionForFile(document_.data(), document_.level(), found, number);
    document_.run(edit::addSolution(document_.tree(), solution));
    return document_.level().solutions.back().name;
}

void KeptInLevel::save() {
    if (!document_.modified()) {
        return;
    }
    if (edit::SaveResult const result = document_.save(); !result.ok()) {
        refuse(document_.path(), result.message);
    }
}

} // namespace trembler
