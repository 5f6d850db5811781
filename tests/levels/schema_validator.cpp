#include "tests/levels/schema_validator.hpp"

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>
#include <stdexcept>

namespace trembler {
namespace {

using Json = nlohmann::json;

class Validator {
public:
    explicit Validator(Json const& root) : root_(root) {}
    std::vector<std::string> problems;

    void check(Json const& schema, Json const& value, std::string const& path) {
        for (auto const& [keyword, expected] : schema.items()) {
            checkKeyword(schema, keyword, expected, value, path);
        }
    }

private:
    [[nodiscard]] bool accepts(Json const& schema, Json const& value, std::string const& path) const {
        Validator inner(root_);
        inner.check(schema, value, path);
        return inner.problems.empty();
    }
    void demand(bool good, std::string const& path, std::string const& what) {
        if (!good) {
            problems.push_back(path + ": " + what);
        }
    }

    static bool isType(std::string const& type, Json const& value) {
        return (type == "object" && value.is_object()) || (type == "array" && value.is_array()) ||
               (type == "string" && value.is_string()) || (type == "boolean" && value.is_boolean()) ||
               (type == "number" && value.is_number()) ||
               (type == "integer" && value.is_number() &&
                value.get<double>() == std::floor(value.get<double>()));
    }

    void checkKeyword(Json const& schema, std::string const& keyword, Json const& expected, Json const& value,
                      std::string const& path) {
        static std::set<std::string> const notes{"$schema", "$defs", "title", "description"};
        if (notes.contains(keyword)) {
            return;
        }
        if (keyword == "$ref") {
            check(root_.at(Json::json_pointer(expected.get<std::string>().substr(1))), value, path);
        } else if (keyword == "type") {
            demand(isType(expected, value), path, "is no " + expected.get<std::string>());
        } else if (keyword == "const") {
            demand(expected == value, path, "is not " + expected.dump());
        } else if (keyword == "enum") {
            demand(std::find(expected.begin(), expected.end(), value) != expected.end(), path, "not listed");
        } else if (keyword == "anyOf" || keyword == "oneOf") {
            auto const matches = std::count_if(expected.begin(), expected.end(),
                                               [&](Json const& one) { return accepts(one, value, path); });
            demand(keyword == "anyOf" ? matches >= 1 : matches == 1, path,
                   keyword + " fits " + std::to_string(matches));
        } else if (!checkNumber(keyword, expected, value, path) &&
                   !checkSize(keyword, expected, value, path) &&
                   !checkMembers(schema, keyword, expected, value, path)) {
            throw std::invalid_argument("unknown keyword " + keyword);
        }
    }

    // Each function returns whether it handles the keyword; it ignores values of other types.
    bool checkNumber(std::string const& keyword, Json const& expected, Json const& value,
                     std::string const& path) {
        if (keyword != "minimum" && keyword != "maximum" && keyword != "exclusiveMinimum") {
            return false;
        }
        if (value.is_number()) {
            double const v = value;
            double const limit = expected;
            demand(keyword == "minimum"   ? v >= limit
                   : keyword == "maximum" ? v <= limit
                                          : v > limit,
                   path, keyword);
        }
        return true;
    }
    bool checkSize(std::string const& keyword, Json const& expected, Json const& value,
                   std::string const& path) {
        static std::set<std::string> const own{"minItems",      "maxItems",  "minProperties",
                                               "maxProperties", "minLength", "maxLength"};
        if (!own.contains(keyword)) {
            return false;
        }
        bool const length = keyword.ends_with("Length") && value.is_string();
        if (length || (keyword.ends_with("Items") && value.is_array()) ||
            (keyword.ends_with("Properties") && value.is_object())) {
            std::size_t const size = length ? value.get_ref<std::string const&>().size() : value.size();
            std::size_t const limit = expected;
            demand(keyword.starts_with("min") ? size >= limit : size <= limit, path, keyword);
        }
        return true;
    }
    bool checkMembers(Json const& schema, std::string const& keyword, Json const& expected, Json const& value,
                      std::string const& path) {
        if (keyword == "items") {
            for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) {
                check(expected, value[i], path + "/" + std::to_string(i));
            }
            return true;
        }
        bool const object = value.is_object();
        if (keyword == "required") {
            for (auto const& key : expected) {
                demand(!object || value.contains(key.get<std::string>()), path, key.dump() + " is missing");
            }
            return true;
        }
        if (keyword == "properties") {
            for (auto const& [key, member] : expected.items()) {
                if (object && value.contains(key)) {
                    check(member, value[key], path + "/" + key);
                }
            }
            return true;
        }
        if (keyword == "patternProperties") {
            for (auto const& [pattern, member] : expected.items()) {
                std::regex const form(pattern, std::regex::ECMAScript);
                for (auto const& [key, one] : value.items()) {
                    if (object && std::regex_search(key, form)) {
                        check(member, one, path + "/" + key);
                    }
                }
            }
            return true;
        }
        if (keyword == "additionalProperties") {
            for (auto const& [key, member] : value.items()) {
                bool named = schema.contains("properties") && schema["properties"].contains(key);
                Json const patterns = schema.value("patternProperties", Json::object());
                for (auto const& [pattern, form] : patterns.items()) {
                    named = named || std::regex_search(key, std::regex(pattern, std::regex::ECMAScript));
                }
                if (!object || named) {
                    continue;
                }
                demand(expected != false, path + "/" + key, "unknown");
                if (expected.is_object()) {
                    check(expected, member, path + "/" + key);
                }
            }
            return true;
        }
        return false;
    }

    Json const& root_;
};

} // namespace

std::vector<std::string> validate(Json const& schema, Json const& value) {
    Validator validator(schema);
    validator.check(schema, value, "");
    return std::move(validator.problems);
}

} // namespace trembler
