// The counters that are put into a text: where each stands, and how much it counts.
#include "lua/sandbox/source/counted_source.hpp"

#include "lua/sandbox/source/assignments.hpp"
#include "lua/sandbox/source/spread_vectors.hpp"
#include "lua/sandbox/source/tokens.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace trembler::lua {
namespace {

/// Walks through the tokens once and notes where counters go and how much they count.
class Counter {
public:
    Counter(std::string_view text, Tokens const& tokens, bool loopsOnly, VectorArguments const* vectors)
        : text_(text), tokens_(tokens), loopsOnly_(loopsOnly), vectors_(vectors), assignments_(tokens) {}

    CountedSource count(std::optional<BlockFault>& fault) {
        bodies_.emplace_back(); // the chunk itself
        blocks_.push_back({Block::function, 0});
        refuseNamesOfTheHost();
        findOwnApply();
        for (at_ = 0; at_ < tokens_.size() && !fault_; ++at_) {
            step(token(at_));
        }
        if (!fault_ && blocks_.size() != 1) {
            fail("a block, a bracket or a function has no end");
        }
        fault = fault_;
        return fault_ ? CountedSource{} : assembled();
    }

private:
    enum class Block { function, loop, repeat, branch, brace, paren, square };
    struct Open {
        Block block;
        std::size_t body; // to which its tokens are counted
    };
    struct Body {
        std::size_t tokens = 0;
        std::size_t whole = 0; // with the loops in it
    };
    struct Place {
        std::size_t position; // in the text
        std::size_t body;
        bool whole;
    };

    [[nodiscard]] Token const& token(std::size_t at) const { return tokens_.token(at); }
    [[nodiscard]] bool isName(std::size_t at) const { return tokens_.isName(at); }
    void fail(std::string message) {
        if (!fault_) {
            fault_ = BlockFault{token(at_).line, std::move(message)};
        }
    }

    // Anywhere: a local, a function or a parameter of such a name would hide the host's.
    void refuseNamesOfTheHost() {
        for (at_ = 0; at_ < tokens_.size() && !fault_; ++at_) {
            Token const& now = token(at_);
            if (now.kind == TokenKind::name &&
                (now.text == CountedSource::counterName || now.text == CountedSource::stopName ||
                 now.text == CountedSource::numbersName)) {
                fail(fmt::format("the name '{}' is the host's", now.text));
            }
        }
    }

    // Whether apply is a function that nothing but the host can call: it stands in the table that is
    // returned, and nowhere else.
    void findOwnApply() {
        auto const countOf = [this](std::string_view word) {
            return std::count_if(tokens_.begin(), tokens_.end(), [&](Token const& each) {
                return each.text == word && (each.kind == TokenKind::name || each.kind == TokenKind::string);
            });
        };
        applyAlone_ = countOf("interaction") == 1 && countOf("apply") == 1;
    }

    void step(Token const& now) {
        Body& body = bodies_[blocks_.back().body];
        ++body.tokens;
        for (std::size_t const trailing : trailing_) {
            ++bodies_[trailing].tokens;
        }
        if (now.kind == TokenKind::name) {
            word(now);
        } else if (now.kind == TokenKind::other) {
            sign(now);
        }
    }

    void word(Token const& now) {
        if (beginsStatement(now.text)) {
            trailing_.clear();
        }
        if (now.text == "function") {
            beginFunction();
        } else if (now.text == "for" || now.text == "while") {
            waiting_.push_back(blocks_.size()); // its 'do' belongs to it
            open(Block::loop, newBody());
        } else if (now.text == "do") {
            if (!waiting_.empty() && waiting_.back() + 1 == blocks_.size()) {
                waiting_.pop_back();
            } else {
                open(Block::loop, newBody());
            }
            places_.push_back({now.end, blocks_.back().body, false});
        } else if (now.text == "repeat") {
            open(Block::repeat, newBody());
            places_.push_back({now.end, blocks_.back().body, false});
        } else if (now.text == "if") {
            open(Block::branch, blocks_.back().body);
        } else if (now.text == "end") {
            close({Block::function, Block::loop, Block::branch});
        } else if (now.text == "until") {
            std::size_t const body = blocks_.back().body;
            close({Block::repeat});
            trailing_.push_back(body); // its condition, which no keyword ends
        } else if (now.text == "goto" && isName(at_ + 1) && !(at_ > 0 && token(at_ - 1).is("."))) {
            places_.push_back({now.begin, function(), true});
        }
    }

    void sign(Token const& now) {
        if (now.text == "(") {
            open(Block::paren, blocks_.back().body);
        } else if (now.text == "[") {
            open(Block::square, blocks_.back().body);
        } else if (now.text == "{") {
            open(Block::brace, blocks_.back().body);
        } else if (now.text == ")") {
            close({Block::paren});
        } else if (now.text == "]") {
            close({Block::square});
        } else if (now.text == "}") {
            close({Block::brace});
        } else if (now.text == "=" && blocks_.back().block != Block::brace) {
            assignments_.findAt(at_);
        }
    }

    std::size_t newBody() {
        bodies_.emplace_back();
        return bodies_.size() - 1;
    }
    void open(Block block, std::size_t body) { blocks_.push_back({block, body}); }
    void close(std::initializer_list<Block> expected) {
        Open const last = blocks_.back();
        if (blocks_.size() == 1 ||
            std::find(expected.begin(), expected.end(), last.block) == expected.end() ||
            (!waiting_.empty() && waiting_.back() + 1 == blocks_.size())) {
            fail(fmt::format("'{}' closes nothing", token(at_).text));
            return;
        }
        blocks_.pop_back();
        if (last.block == Block::function && last.body == applyBody_) {
            applyAlone_ =
                applyAlone_ && (token(at_ + 1).is(",") || token(at_ + 1).is(";") || token(at_ + 1).is("}"));
        } else if (last.block == Block::brace && blocks_.size() == 1) {
            lastTableEnd_ = at_;
        }
        if (last.body != blocks_.back().body && last.block != Block::function) {
            bodies_[blocks_.back().body].whole += bodies_[last.body].tokens + bodies_[last.body].whole;
        }
    }
    // The body of the function that is open innermost.
    [[nodiscard]] std::size_t function() const {
        auto const at = std::find_if(blocks_.rbegin(), blocks_.rend(),
                                     [](Open const& open) { return open.block == Block::function; });
        return at->body;
    }

    // function NAME(...), function(...): the names and the parameters are read here.
    void beginFunction() {
        std::size_t const start = at_;
        bool const ofApply = isApplyHere();
        while (isName(at_ + 1) || token(at_ + 1).is(".") || token(at_ + 1).is(":")) {
            ++at_;
        }
        bool const local = start > 0 && token(start - 1).is("local");
        bodies_[blocks_.back().body].tokens += at_ - start;
        if (at_ > start + 1) {
            assignments_.addField(); // function a.b()
        } else if (at_ == start + 1 && !local) {
            assignments_.addName(token(at_).text);
        }
        std::size_t const names = at_ + 1;
        if (!token(names).is("(")) {
            fail("a function has no parameters; expected (...)");
            return;
        }
        at_ = names;
        std::size_t parameter = 0;
        while (at_ < tokens_.size() && !token(at_).is(")")) {
            ++at_;
            if (isName(at_)) {
                ++parameter;
                bool const itself = ofApply && (parameter == 4 || parameter == 5);
                assignments_.addParameter(token(at_).text, itself);
                if (ofApply && vectors_ != nullptr && parameter == vectors_->parameter) {
                    out_ = token(at_).text;
                }
            }
        }
        open(Block::function, newBody());
        if (ofApply) {
            parameters_ = token(at_ - 1).is("...") ? CountedSource::anyNumber : parameter;
            applyBody_ = blocks_.back().body;
            applyPlace_ = token(at_).end;
        } else if (!loopsOnly_) {
            places_.push_back({token(at_).end, blocks_.back().body, false});
        }
    }
    // 'apply = function' in the table of 'return interaction {'.
    [[nodiscard]] bool isApplyHere() const {
        return applyAlone_ && at_ >= 2 && token(at_ - 1).is("=") && token(at_ - 2).is("apply") &&
               blocks_.size() == 2 && blocks_.back().block == Block::brace && returnsTable();
    }
    // Whether the brace that is open is that of 'return interaction {'.
    [[nodiscard]] bool returnsTable() const {
        for (std::size_t i = 0; i + 2 < tokens_.size(); ++i) {
            if (token(i + 1).is("interaction")) {
                return token(i).is("return") && token(i + 2).is("{") && i < at_;
            }
        }
        return false;
    }

    [[nodiscard]] static std::size_t instructions(std::size_t tokens) { return (tokens + 1) / 2; }

    CountedSource assembled() {
        CountedSource made;
        // The table must be all that is returned, and the function all that stands in it under its name: an
        // operator behind one of them could hand it to a function of the script.
        std::size_t const last = !tokens_.empty() && tokens_.back().is(";") ? 2 : 1;
        if (applyBody_ != 0 && (!applyAlone_ || lastTableEnd_ + last != tokens_.size())) {
            places_.push_back({applyPlace_, applyBody_, false});
            applyBody_ = 0;
        }
        made.chunk = instructions(bodies_.front().tokens);
        made.apply = applyBody_ == 0 ? 0 : std::max<std::size_t>(1, instructions(bodies_[applyBody_].tokens));
        made.parameters = applyBody_ == 0 ? CountedSource::anyNumber : parameters_;
        made.assignsFields = assignments_.ofFields();
        made.assigned = assignments_.names();
        std::vector<TextEdit> edits;
        if (vectors_ != nullptr && applyBody_ != 0) {
            edits = spreadVectors(tokens_, out_, *vectors_);
        }
        if (made.assignsFields && !loopsOnly_) {
            for (Token const& each : tokens_) {
                if (each.kind == TokenKind::other && each.is("#")) {
                    edits.push_back(
                        {each.begin, each.text.size(), fmt::format(" {}^", CountedSource::lengthName)});
                }
            }
        }
        for (Place const& place : places_) {
            Body const& body = bodies_[place.body];
            std::size_t const count = instructions(body.tokens + (place.whole ? body.whole : 0));
            edits.push_back({place.position, 0,
                             fmt::format(" {0}={0}-{2} if {0}<0 then {1}()end ", CountedSource::counterName,
                                         CountedSource::stopName, std::max<std::size_t>(1, count))});
        }
        std::stable_sort(edits.begin(), edits.end(),
                         [](TextEdit const& a, TextEdit const& b) { return a.position < b.position; });
        made.text = fmt::format("local {0},{1}=0,... return function(...) ", CountedSource::counterName,
                                CountedSource::stopName);
        std::size_t copied = tokens_.empty() ? text_.size() : tokens_.front().begin;
        made.text.append(static_cast<std::size_t>(std::count(
                             text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(copied), '\n')),
                         '\n');
        for (TextEdit const& edit : edits) {
            made.text += text_.substr(copied, edit.position - copied);
            made.text += edit.inserted;
            copied = edit.position + edit.removed;
        }
        made.text += text_.substr(copied);
        made.text += "\nend";
        return made;
    }

    std::string_view text_;
    Tokens const& tokens_;
    bool loopsOnly_;
    VectorArguments const* vectors_;
    std::string_view out_; // the name of the parameter by which apply makes calls
    std::size_t at_ = 0;
    std::vector<Body> bodies_;
    std::vector<Open> blocks_;
    std::vector<std::size_t> waiting_;  // depths at which a 'do' is expected
    std::vector<std::size_t> trailing_; // bodies of 'repeat' whose condition may go on
    std::vector<Place> places_;
    std::optional<BlockFault> fault_;
    Assignments assignments_;
    std::size_t applyBody_ = 0; // 0: none that only the host can call
    std::size_t applyPlace_ = 0;
    std::size_t parameters_ = CountedSource::anyNumber;
    std::size_t lastTableEnd_ = 0;
    bool applyAlone_ = false;
};

} // namespace

CountedSource countSource(std::string_view text, std::optional<BlockFault>& fault, bool loopsOnly,
                          VectorArguments const* vectors) {
    Tokens const tokens(text);
    return Counter(text, tokens, loopsOnly, vectors).count(fault);
}

} // namespace trembler::lua
