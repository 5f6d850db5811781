// What the benchmarks share: timing, medians, and a table that says whether a limit is held.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace bench {

/// Keeps the compiler from leaving out work whose result nobody looks at.
template <class T>
inline void keep(T const& value) {
    asm volatile("" : : "g"(&value) : "memory");
}

/// Durations of repetitions of one thing. Alternate the things to be compared, so that what disturbs the
/// machine disturbs all of them, and compare medians.
class Series {
public:
    template <class F>
    void time(F&& f) {
        auto const begin = std::chrono::steady_clock::now();
        f();
        std::chrono::duration<double> const took = std::chrono::steady_clock::now() - begin;
        seconds_.push_back(took.count());
    }
    void add(double seconds) { seconds_.push_back(seconds); }
    /// In s; 0 if nothing was timed.
    [[nodiscard]] double median() const { return quantile(0.5); }
    /// The duration that this share of all, 0 to 1, is shorter than. A small one tells what a machine that
    /// has other work does when it has none.
    [[nodiscard]] double quantile(double share) const {
        if (seconds_.empty()) {
            return 0;
        }
        std::vector<double> sorted = seconds_;
        auto const last = static_cast<double>(sorted.size() - 1);
        auto const at = sorted.begin() + static_cast<std::ptrdiff_t>(
                                             std::min(share * static_cast<double>(sorted.size()), last));
        std::nth_element(sorted.begin(), at, sorted.end());
        return *at;
    }

private:
    std::vector<double> seconds_;
};

/// Rows of name, value and unit; where there is a limit, what it applies to and whether it is held.
class Table {
public:
    explicit Table(std::string title) : title_(std::move(title)) {}

    void row(std::string name, double value, std::string unit) {
        rows_.push_back({std::move(name), value, std::move(unit), false, 0, 0});
    }
    /// `measured` must not exceed `limit`.
    void row(std::string name, double value, std::string unit, double measured, double limit) {
        rows_.push_back({std::move(name), value, std::move(unit), true, measured, limit});
    }
    void print() const {
        std::printf("%s\n", title_.c_str());
        for (Row const& row : rows_) {
            std::printf("  %-56s %10.3f %s\n", row.name.c_str(), row.value, row.unit.c_str());
        }
        for (Row const& row : rows_) {
            if (row.limited) {
                std::printf("  limit %g for \"%s\": %.3f, %s\n", row.limit, row.name.c_str(), row.measured,
                            row.measured <= row.limit ? "held" : "MISSED");
            }
        }
        std::printf("\n");
    }

private:
    struct Row {
        std::string name;
        double value;
        std::string unit;
        bool limited;
        double measured;
        double limit;
    };
    std::string title_;
    std::vector<Row> rows_;
};

} // namespace bench
