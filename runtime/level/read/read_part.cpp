#include "runtime/level/read/read_part.hpp"

#include "runtime/file/folder_files.hpp"
#include "runtime/level/property/property_reader.hpp"
#include "runtime/level/read/read_pieces.hpp"
#include "runtime/level/read/read_texts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace trembler {
namespace {

/// The look of a part is an ordinary property, but files state it next to the part's title.
constexpr std::string_view lookKey = "look";

std::vector<PartGroup> readGroups(JsonNode const& node) {
    std::vector<PartGroup> groups;
    if (node.isList("a list of groups", partGroupNames.size())) {
        for (std::size_t i = 0; i < node.size(); ++i) {
            auto const group = node.element(i).choice(partGroupNames);
            bool const again = group && std::count(groups.begin(), groups.end(), PartGroup(*group)) > 0;
            if (again) {
                node.element(i).complain("is stated twice", "every group once");
            } else if (group) {
                groups.push_back(PartGroup(*group));
            }
        }
    }
    return groups;
}

} // namespace

PartDefinition readPart(Registry const& registry, std::shared_ptr<JsonDocument const> const& document) {
    Problems problems;
    PartDefinition part;
    part.document = document;
    MemberReader reader(
        JsonNode(*document, document->root(), "", problems),
        "a part: an object {\"name\", \"title\", \"text\", \"look\", \"properties\", \"objects\"}");
    reader.know("$schema"); // for editors
    if (reader.valid()) {
        if (auto const name = reader.required("name", "a name that no other part has")) {
            part.name = name->name("a name").value_or("");
        }
        part.title = part.name;
        if (auto const title = reader.optional("title")) {
            part.title = title->name("a title").value_or("");
        }
        if (auto const text = reader.optional("text")) {
            part.text = text->text().value_or("");
        }
        if (auto const texts = reader.optional("texts")) {
            part.texts = readTexts(*texts, TextsOf::part);
        }
        if (auto const groups = reader.optional("groups")) {
            part.groups = readGroups(*groups);
        }
        readPieces(reader, registry, part);
        NameTable* const names =
            part.composite() ? &part.names : nullptr; // a part of one object has no other objects to refer to
        PropertyInfo const* const look = registry.objectProperty(lookKey);
        if (look != nullptr) {
            if (auto const node = reader.optional(std::string(lookKey))) {
                readPropertyInto(part.properties, *look, *node, names);
            }
        }
        if (auto const properties = reader.optional("properties")) {
            readProperties(part.properties, registry, PropertyPlace::properties, *properties, names);
            if (look != nullptr && reader.node().has(std::string(lookKey)) &&
                properties->has(std::string(lookKey))) {
                properties->complainAboutKey(std::string(lookKey), "is stated twice", "\"look\" once");
            }
        }
        reader.finish();
    }
    problems.throwIfAny();
    return part;
}

std::vector<std::filesystem::path> partFiles(std::filesystem::path const& folder,
                                             std::vector<Diagnostic>& faults, PartLimits const& most) {
    FolderFiles const found = filesIn(folder, ".json", most.files);
    auto const complain = [&](std::string message, std::string expected) {
        faults.push_back({.file = folder.string(),
                          .path = "",
                          .message = std::move(message),
                          .expected = std::move(expected)});
    };
    if (found.error) {
        complain(fmt::format("the folder of parts cannot be read: {}", found.error.message()), "");
    }
    if (found.leftOut > 0) {
        complain(fmt::format("has {} files of parts", found.files.size() + found.leftOut),
                 fmt::format("at most {}", most.files));
    }
    std::uintmax_t bytes = most.before;
    for (std::filesystem::path const& file : found.files) {
        std::error_code ignored; // reading the file reports it
        std::uintmax_t const size = std::filesystem::file_size(file, ignored);
        bytes += ignored ? 0 : size;
    }
    if (bytes > most.bytes) {
        complain(
            most.before == 0
                ? fmt::format("its files of parts have {} bytes together", bytes)
                : fmt::format("its files of parts and those of the other mods have {} bytes together", bytes),
            fmt::format("at most {}", most.bytes));
        return {};
    }
    return found.files;
}

PartLibrary loadParts(Registry const& registry, std::filesystem::path const& folder, PartLimits const& most) {
    Problems problems;
    std::vector<Diagnostic> faults;
    std::vector<std::filesystem::path> const files = partFiles(folder, faults, most);
    for (Diagnostic& fault : faults) {
        problems.add(std::move(fault));
    }
    PartLibrary library;
    for (std::filesystem::path const& file : files) {
        try {
            library.add(readPart(registry, JsonDocument::load(file)));
        } catch (InputError const& bad) {
            for (Diagnostic const& diagnostic : bad.diagnostics()) {
                problems.add(diagnostic);
            }
        }
    }
    problems.throwIfAny();
    return library;
}

} // namespace trembler
