// A JSON file in memory that can find the place of each value in its text.
#pragma once

#include "runtime/level/json/diagnostic.hpp"
#include "runtime/level/json/json_locator.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <memory>

namespace trembler {

class JsonDocument {
public:
    /// Parses a text; `file` is its name for people. Throws InputError, and nothing else, for text that is
    /// not JSON (RFC 8259), for repeated keys in an object, for numbers too large for a double, for too deep
    /// nesting and for too long text.
    [[nodiscard]] static std::shared_ptr<JsonDocument const> parse(std::string text, std::string file);
    /// The text of a file. Throws InputError if it cannot be read, is a folder or is too large.
    [[nodiscard]] static std::string readText(std::filesystem::path const& path);
    /// Reads and parses a file. Throws InputError, also if the file cannot be read.
    [[nodiscard]] static std::shared_ptr<JsonDocument const> load(std::filesystem::path const& path);

    [[nodiscard]] nlohmann::json const& root() const { return root_; }
    [[nodiscard]] std::string const& file() const { return file_; }
    [[nodiscard]] std::string const& text() const { return text_; }
    /// A problem with the value at a JSON pointer.
    [[nodiscard]] Diagnostic diagnostic(std::string path, std::string message, std::string expected,
                                        Spot spot = Spot::value) const;

private:
    JsonDocument(std::string text, std::string file);

    std::string text_;
    std::string file_;
    nlohmann::json root_;
};

} // namespace trembler
