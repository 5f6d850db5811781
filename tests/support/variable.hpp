// A variable of the environment that has another value while this lives. One thread at a time.
#pragma once

#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

namespace trembler::test {

class Variable {
public:
    /// `value` null: the variable is not set.
    Variable(std::string name, char const* value) : name_(std::move(name)) {
        if (char const* const before = std::getenv(name_.c_str())) {
            before_ = before;
        }
        set(value);
    }
    ~Variable() { set(before_ ? before_->c_str() : nullptr); }
    Variable(Variable const&) = delete;
    Variable& operator=(Variable const&) = delete;

private:
    void set(char const* value) const {
        if (value == nullptr) {
            ::unsetenv(name_.c_str());
        } else {
            ::setenv(name_.c_str(), value, 1);
        }
    }

    std::string name_;
    std::optional<std::string> before_;
};

} // namespace trembler::test
