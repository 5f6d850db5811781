#include "runtime/level/json/json_document.hpp"

#include "runtime/file/cut_text.hpp"
#include "runtime/level/json/add_problem.hpp"
#include "runtime/level/json/limits.hpp"
#include "runtime/level/json/read_text.hpp"
#include "runtime/level/json/refuse_file.hpp"
#include "runtime/level/json/text_limits.hpp"

#include <fmt/format.h>

#include <utility>

namespace trembler {
namespace {

/// Builds the tree. Unlike the library's own builder it reports repeated keys, and stops early if there are
/// too many problems.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
public:
    struct Flaw {
        std::string path;
        std::string message;
        std::string expected;
        std::optional<std::size_t> offset;
        Spot spot = Spot::value;
    };
    [[nodiscard]] nlohmann::json take() { return std::move(root_); }
    [[nodiscard]] std::vector<Flaw> const& flaws() const { return flaws_; }

    bool null() override { return put(nullptr); }
    bool boolean(bool value) override { return put(value); }
    bool number_integer(number_integer_t value) override { return put(value); }
    bool number_unsigned(number_unsigned_t value) override { return put(value); }
    bool number_float(number_float_t value, string_t const&) override { return put(value); }
    bool string(string_t& value) override { return put(std::move(value)); }
    bool binary(binary_t&) override { return false; }
    bool start_object(std::size_t) override { return open(nlohmann::json::object()); }
    bool start_array(std::size_t) override { return open(nlohmann::json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool key(string_t& name) override {
        Level& level = open_.back();
        if (name.size() > limits::key) {
            std::string const path = pathOfNext(); // with the key before this one
            flaws_.push_back({path.substr(0, path.rfind('/')),
                              fmt::format("has a key of {} bytes", name.size()),
                              fmt::format("at most {}", limits::key), std::nullopt, Spot::value});
            return false;
        }
        level.key = name;
        if (level.node->contains(name)) {
            if (std::string path = pathOfNext(); flaws_.empty() || flaws_.back().path != path) {
                flaws_.push_back({std::move(path), fmt::format("the key '{}' is repeated", name),
                                  "every key once", std::nullopt, Spot::lastKey});
            }
        }
        return flaws_.size() < Problems::most; // further problems would not be kept
    }
    bool parse_error(std::size_t position, std::string const&,
                     nlohmann::detail::exception const& error) override {
        // The message quotes the text, which may not be UTF-8. Such a message could not be printed or stored.
        std::string const quoted =
            nlohmann::json(error.what()).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
        std::string message = nlohmann::json::parse(quoted).get<std::string>();
        if (std::size_t const at = message.find("syntax error"); at != std::string::npos) {
            message = message.substr(at);
        } else if (std::size_t const bracket = message.find("] "); bracket != std::string::npos) {
            message = message.substr(bracket + 2);
        }
        std::string expected;
        if (std::size_t const at = message.find("; expected "); at != std::string::npos) {
            expected = message.substr(at + std::string_view("; expected ").size());
            message.resize(at);
        }
        constexpr std::size_t longest = 300; // the message may quote a value of many megabytes
        message = cutText(std::move(message), longest);
        flaws_.push_back({"", message, expected, position == 0 ? 0 : position - 1, Spot::value});
        return false;
    }

private:
    struct Level {
        nlohmann::json* node;
        std::string key; // of the next member
    };

    [[nodiscard]] std::string pathOfNext() const {
        std::string path;
        for (Level const& level : open_) {
            bool const innermost = &level == &open_.back();
            path = level.node->is_array() ? pointerTo(path, level.node->size() - (innermost ? 0 : 1))
                                          : pointerTo(path, level.key);
        }
        return path;
    }
    /// Whether the limit allows one more value; otherwise reading ends here.
    bool mayGrow() {
        if (++values_ > limits::values) {
            flaws_.push_back({"", "has too many values", fmt::format("at most {}", limits::values),
                              std::size_t{0}, Spot::value});
            return false;
        }
        return true;
    }
    nlohmann::json* place(nlohmann::json value) {
        if (open_.empty()) {
            root_ = std::move(value);
            return &root_;
        }
        Level& level = open_.back();
        if (level.node->is_array()) {
            level.node->push_back(std::move(value));
            return &level.node->back();
        }
        nlohmann::json& member = (*level.node)[level.key];
        member = std::move(value);
        return &member;
    }
    template <class T>
    bool put(T&& value) {
        if (!mayGrow()) {
            return false;
        }
        place(nlohmann::json(std::forward<T>(value)));
        return true;
    }
    bool open(nlohmann::json container) {
        if (open_.size() == limits::depth) {
            flaws_.push_back({pathOfNext(), "nested too deeply",
                              fmt::format("at most {} lists and objects inside one another", limits::depth),
                              std::nullopt, Spot::value});
            return false;
        }
        if (!mayGrow()) {
            return false;
        }
        open_.push_back({place(std::move(container)), {}});
        return true;
    }
    bool close() {
        open_.pop_back();
        return true;
    }

    nlohmann::json root_;
    std::size_t values_ = 0;
    std::vector<Level> open_; // pointers stay valid: only the innermost container grows
    std::vector<Flaw> flaws_;
};

} // namespace

JsonDocument::JsonDocument(std::string text, std::string file)
    : text_(std::move(text)), file_(std::move(file)) {
    if (text_.size() > limits::fileSize) {
        refuseFile(file_, fmt::format("has {} bytes", text_.size()),
                   fmt::format("at most {}", limits::fileSize));
    }
    TreeBuilder builder;
    bool const whole = nlohmann::json::sax_parse(text_, &builder);
    if (whole && builder.flaws().empty()) {
        root_ = builder.take();
        return;
    }
    Problems problems;
    for (auto const& flaw : builder.flaws()) {
        addProblem(problems, [&] {
            Diagnostic made = diagnostic(flaw.path, flaw.message, flaw.expected, flaw.spot);
            if (flaw.offset) {
                TextPlace const place = placeOf(text_, *flaw.offset);
                made.line = place.line;
                made.column = place.column;
            }
            return made;
        });
    }
    problems.throwIfAny();
    refuseFile(file_, "is not JSON", "one JSON value");
}

std::shared_ptr<JsonDocument const> JsonDocument::parse(std::string text, std::string file) {
    return std::shared_ptr<JsonDocument const>(new JsonDocument(std::move(text), std::move(file)));
}

std::string JsonDocument::readText(std::filesystem::path const& path) {
    return trembler::readText(path, limits::fileSize);
}

std::shared_ptr<JsonDocument const> JsonDocument::load(std::filesystem::path const& path) {
    return parse(readText(path), path.string());
}

Diagnostic JsonDocument::diagnostic(std::string path, std::string message, std::string expected,
                                    Spot spot) const {
    TextPlace const place = placeOf(text_, locate(text_, path, spot));
    return {file_, place.line, place.column, std::move(path), std::move(message), std::move(expected)};
}

} // namespace trembler
