#include "lua/sandbox/source/spread_vectors.hpp"

#include "lua/sandbox/source/counted_source.hpp"

#include <algorithm>
#include <optional>

namespace trembler::lua {
namespace {

constexpr std::string_view maker = "vec2";

class Spreader {
public:
    Spreader(Tokens const& tokens, std::string_view out, VectorArguments const& arguments)
        : tokens_(tokens), out_(out), arguments_(arguments) {}

    std::vector<TextEdit> edits() {
        if (out_.empty() || out_ == maker || !makerIsTheHosts() || !outIsTheParameter()) {
            return {};
        }
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            if (isVariable(i, out_) && token(i + 1).is(".") && isName(i + 2) && token(i + 3).is("(")) {
                auto const call = arguments_.calls.find(token(i + 2).text);
                if (call != arguments_.calls.end()) {
                    spreadCall(i, call->second);
                }
            }
        }
        std::sort(edits_.begin(), edits_.end(),
                  [](TextEdit const& a, TextEdit const& b) { return a.position < b.position; });
        return std::move(edits_);
    }

private:
    [[nodiscard]] Token const& token(std::size_t at) const { return tokens_.token(at); }
    [[nodiscard]] bool isName(std::size_t at) const { return tokens_.isName(at); }
    /// Whether the token is that name, and not the name of a field.
    [[nodiscard]] bool isVariable(std::size_t at, std::string_view name) const {
        return token(at).is(name) && !(at > 0 && (token(at - 1).is(".") || token(at - 1).is(":")));
    }
    /// Whether a name stands in the list of a 'local' or 'for', or after a 'function'.
    [[nodiscard]] bool isDeclared(std::size_t at) const {
        while (at >= 2 && token(at - 1).is(",") && isName(at - 2)) {
            at -= 2;
        }
        return at > 0 &&
               (token(at - 1).is("local") || token(at - 1).is("for") || token(at - 1).is("function"));
    }

    // vec2 is called wherever it stands, so nothing is assigned to it, and no parameter has its name.
    [[nodiscard]] bool makerIsTheHosts() const {
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            if (isVariable(i, maker) && (!token(i + 1).is("(") || isDeclared(i))) {
                return false;
            }
        }
        return true;
    }
    // Wherever `out` stands, except as the parameter itself, a field of it follows.
    [[nodiscard]] bool outIsTheParameter() const {
        std::size_t others = 0;
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            others += isVariable(i, out_) && (!token(i + 1).is(".") || isDeclared(i)) ? 1 : 0;
        }
        return others == 1;
    }

    /// An expression in a list: its first token, and the ',' or the bracket behind it.
    struct Expression {
        std::size_t begin = 0;
        std::size_t end = 0;
    };
    // The list whose first token is at `at`; nothing if there is a function in it, whose statements have
    // commas of their own.
    [[nodiscard]] std::optional<std::vector<Expression>> listAt(std::size_t at) const {
        std::vector<Expression> all;
        std::size_t begin = at;
        std::size_t depth = 0;
        for (; at < tokens_.size(); ++at) {
            Token const& now = token(at);
            if (now.is("function")) {
                return std::nullopt;
            }
            bool const closes = now.is(")") || now.is("]") || now.is("}");
            if (depth == 0 && (closes || now.is(","))) {
                if (at == begin) {
                    return std::nullopt;
                }
                all.push_back({begin, at});
                begin = at + 1;
                if (closes) {
                    return all;
                }
            } else if (closes) {
                --depth;
            } else if (now.is("(") || now.is("[") || now.is("{")) {
                ++depth;
            }
        }
        return std::nullopt;
    }

    /// Changes the call whose 'out' stands at `at`.
    void spreadCall(std::size_t at, std::vector<bool> const& vectors) {
        auto const stated = listAt(at + 4);
        auto const last = std::find(vectors.rbegin(), vectors.rend(), true);
        if (!stated || last == vectors.rend() || stated->size() > vectors.size() ||
            stated->size() < static_cast<std::size_t>(vectors.rend() - last)) {
            return; // its function takes two values for each vector: none may be left out
        }
        std::vector<TextEdit> edits{
            {token(at).begin, token(at).text.size(), std::string(CountedSource::numbersName)}};
        for (std::size_t i = 0; i < stated->size(); ++i) {
            if (vectors[i] && !spread((*stated)[i], i + 1 == stated->size(), edits)) {
                return; // the arguments behind it would be taken for others
            }
        }
        edits_.insert(edits_.end(), edits.begin(), edits.end());
    }

    /// Whether an expression may have several values, or none: it ends with a call or with '...'.
    [[nodiscard]] bool mayBeSeveral(Expression const& expression) const {
        Token const& last = token(expression.end - 1);
        return last.is("...") || last.is(")") || last.is("}") || last.kind == TokenKind::string;
    }

    bool spread(Expression const& whole, bool isLast, std::vector<TextEdit>& edits) const {
        Token const& name = token(whole.begin);
        Token const& bracket = token(whole.begin + 1);
        if (!name.is(maker) || !bracket.is("(") || name.line != bracket.line) {
            return false;
        }
        auto const numbers = listAt(whole.begin + 2);
        if (!numbers || numbers->size() != 2 || numbers->back().end + 1 != whole.end) {
            return false;
        }
        Token const& comma = token(numbers->front().end);
        bool const several = mayBeSeveral(numbers->back());
        if (several && !isLast) {
            return false; // its second value would be taken for the next argument
        }
        edits.push_back({name.begin, bracket.end - name.begin, "("});
        edits.push_back({comma.begin, 1, several ? ")," : "),("});
        if (several) { // all its values are handed on, so that vec2 is refused as it would be
            edits.push_back({token(numbers->back().end).begin, 1, ""});
        }
        return true;
    }

    Tokens const& tokens_;
    std::string_view out_;
    VectorArguments const& arguments_;
    std::vector<TextEdit> edits_;
};

} // namespace

std::vector<TextEdit> spreadVectors(Tokens const& tokens, std::string_view out,
                                    VectorArguments const& arguments) {
    return Spreader(tokens, out, arguments).edits();
}

} // namespace trembler::lua
