#include "puzzle/data/own_part_files.hpp"

#include "runtime/level/build/check_composites.hpp"
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/read/read_part.hpp"

#include <fmt/format.h>

#include <string>
#include <system_error>
#include <utility>

namespace trembler {
namespace {

namespace fs = std::filesystem;

void append(std::vector<Diagnostic>& faults, InputError const& error) {
    faults.insert(faults.end(), error.diagnostics().begin(), error.diagnostics().end());
}

Diagnostic conflictOf(PartDefinition const& part, PartDefinition const& other) {
    std::string const message =
        other.document == nullptr
            ? fmt::format("there is already a part '{}'", part.name)
            : fmt::format("there is already a part '{}' in {}", part.name, other.document->file());
    return part.document->diagnostic("/name", message, "a name that no other part has");
}

/// Adds a part if the library can be used with it. Says why not otherwise.
std::vector<Diagnostic> addIfUsable(PartLibrary& library, PartDefinition const& part) {
    if (PartDefinition const* const other = library.find(part.name)) {
        return {conflictOf(part, *other)};
    }
    PartLibrary with = library;
    try {
        with.add(part);
        checkComposites(with);
    } catch (InputError const& error) {
        return error.diagnostics();
    }
    library = std::move(with);
    return {};
}

} // namespace

std::vector<Diagnostic> addOwnParts(Registry const& registry, fs::path const& folder, PartLibrary& library,
                                    PartLimits const& most, std::vector<DamagedFile>* damaged) {
    std::vector<Diagnostic> faults;
    std::vector<PartDefinition> left;
    std::error_code error;
    if (folder.empty() || !fs::exists(folder, error)) {
        return faults;
    }
    for (fs::path const& file : partFiles(folder, faults, most)) {
        try {
            KeptText found = KeptFile(file).look();
            if (found.damaged && damaged != nullptr) {
                damaged->push_back(*found.damaged);
            }
            // Without any good version the damaged one is read, for the place of its fault.
            left.push_back(readPart(registry, found.text
                                                  ? JsonDocument::parse(std::move(*found.text), file.string())
                                                  : JsonDocument::load(file)));
        } catch (InputError const& error) {
            append(faults, error);
        }
    }
    // One may consist of another whose file comes later: as long as any can be added, the rest is tried
    // again.
    for (bool added = true; added && !left.empty();) {
        added = std::erase_if(
                    left, [&](PartDefinition const& part) { return addIfUsable(library, part).empty(); }) > 0;
    }
    for (PartDefinition const& part : left) {
        std::vector<Diagnostic> const why = addIfUsable(library, part);
        faults.insert(faults.end(), why.begin(), why.end());
    }
    return faults;
}

} // namespace trembler
