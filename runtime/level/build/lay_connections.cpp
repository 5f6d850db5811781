#include "runtime/level/build/lay_connections.hpp"

#include "runtime/level/json/add_problem.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace trembler {
namespace {

class Layer {
public:
    Layer(Registry const& registry, LevelFile const& level, Store& store, Problems& problems)
        : connectors_(registry.connectors()), kinds_(registry.connectionKinds()), level_(level),
          store_(store), problems_(problems) {}

    void lay(LevelConnection const& connection) {
        ObjectId const a = store_.find(connection.a);
        ObjectId const b = store_.find(connection.b);
        if (connectors_.empty()) {
            problem("/connections", "no effect of this program has connections", "no connections");
        } else if (!a.valid() || !b.valid()) {
            problem(connection.path,
                    fmt::format("there is no object '{}'", a.valid() ? connection.b : connection.a),
                    "the name of an object of this level");
        } else if (connection.kind.empty()) {
            layByWhatItConnects(connection, a, b);
        } else {
            layByKind(connection, a, b);
        }
    }

private:
    void layByKind(LevelConnection const& connection, ObjectId a, ObjectId b) {
        auto const found =
            std::find_if(connectors_.begin(), connectors_.end(),
                         [&](Connector const& connector) { return connector.kind == connection.kind; });
        if (found == connectors_.end()) {
            problem(connection.path.empty() ? "" : connection.path + "/kind",
                    fmt::format("there is no kind of connection '{}'{}", connection.kind,
                                didYouMean(connection.kind, kinds_)),
                    listed(kinds_));
        } else if (auto const wrong = found->refusal(store_, a, b)) {
            problem(connection.path, *wrong, "");
        } else {
            found->lay(store_, a, b);
        }
    }

    void layByWhatItConnects(LevelConnection const& connection, ObjectId a, ObjectId b) {
        std::vector<Connector const*> able;
        std::vector<std::string> ways;
        std::string refusals;
        for (Connector const& connector : connectors_) {
            if (auto const wrong = connector.refusal(store_, a, b)) {
                refusals +=
                    connectors_.size() == 1 ? *wrong : fmt::format("; no {}: {}", connector.kind, *wrong);
            } else {
                able.push_back(&connector);
                ways.emplace_back(connector.kind);
            }
        }
        if (able.size() == 1) {
            able.front()->lay(store_, a, b);
        } else if (connectors_.size() == 1) {
            problem(connection.path, refusals, "");
        } else if (able.empty()) {
            problem(connection.path,
                    fmt::format("nothing can connect '{}' and '{}'{}", connection.a, connection.b, refusals),
                    "");
        } else {
            std::sort(ways.begin(), ways.end());
            problem(connection.path,
                    fmt::format("'{}' and '{}' can be connected in more than one way", connection.a,
                                connection.b),
                    fmt::format(R"({{"between": ["{}", "{}"], "kind": one of {}}})", connection.a,
                                connection.b, listed(ways)));
        }
    }

    void problem(std::string path, std::string message, std::string expected) {
        addProblem(problems_, [&] {
            return level_.diagnostic(std::move(path), std::move(message), std::move(expected));
        });
    }

    std::span<Connector const> connectors_;
    std::vector<std::string> kinds_;
    LevelFile const& level_;
    Store& store_;
    Problems& problems_;
};

} // namespace

void layConnections(Registry const& registry, LevelFile const& level, std::span<LevelConnection const> wires,
                    Store& store, Problems& problems) {
    std::vector<LevelConnection> sorted = level.connections;
    sorted.insert(sorted.end(), wires.begin(), wires.end());
    for (LevelConnection& connection : sorted) {
        if (connection.b < connection.a) {
            std::swap(connection.a, connection.b);
        }
    }
    std::sort(sorted.begin(), sorted.end(), [](LevelConnection const& x, LevelConnection const& y) {
        return std::tie(x.a, x.b, x.kind) < std::tie(y.a, y.b, y.kind);
    });
    Layer layer(registry, level, store, problems);
    for (LevelConnection const& connection : sorted) {
        layer.lay(connection);
    }
}

} // namespace trembler
