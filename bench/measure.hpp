// Shared by the benchmarks: timing, medians, and a table of results and limits.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace bench {

/// Keeps the compiler from removing work whose result is not used.
template <class T>
inline void keep(T const& value) {
    asm volatile("" : : "g"(&value) : "memory");
}

/// Durations of repetitions of one measurement. Alternate the measurements to be compared, so that other load
/// on the machine affects all of them, and compare medians.
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
    /// s; 0 if nothing was timed.
    [[nodiscard]] double median() const { return quantile(0.5); }
    /// The given quantile of the durations, `share` from 0 to 1. A small quantile estimates the duration on a
    /// machine without other load.
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

/// Rows of name, value and unit; for rows with a limit also the limited quantity and whether the limit is
/// kept.
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
