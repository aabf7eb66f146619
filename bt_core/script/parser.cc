// By precedence climbing (Richards 1979): operators and their precedences are a table (grammar.h),
// so one function reads all of them. Who writes a script wants all mistakes at once, but each once:
// after a failure the functions at work run to the end of the statement in silence. A node is
// appended behind its operands, so that the checker meets these first without recursion.
#include "bt_core/script/parser.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "bt_core/base/diagnostic.h"
#include "bt_core/script/grammar.h"
#include "bt_core/script/token.h"

namespace coppice::script {
namespace {

std::string Quoted(std::string_view text) { return "\"" + std::string(text) + "\""; }

class Parser {
 public:
  Parser(std::string_view script, std::vector<ScriptProblem>& problems)
      : problems_(problems), tokens_(Tokenize(script, problems)) {}

  Ast Run() {
    while (Peek().kind != TokenKind::kEnd) {
      if (Accept(";")) continue;
      Statement();
    }
    if (ast_.statements.empty() && problems_.empty()) Fail("the script is empty", {});
    return std::move(ast_);
  }

 private:
  // Counts how deep the parser has called itself.
  class Level {
   public:
    explicit Level(Parser& parser) : parser_(parser) { ++parser_.level_; }
    ~Level() { --parser_.level_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    Parser& parser_;
  };

  const Token& Peek(std::size_t ahead = 0) const {
    return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
  }
  const Token& Before() const { return tokens_[at_ == 0 ? 0 : at_ - 1]; }
  const Token& Take() { return tokens_[at_ + 1 < tokens_.size() ? at_++ : at_]; }
  bool Accept(std::string_view symbol) {
    if (!Peek().Is(symbol)) return false;
    Take();
    return true;
  }

  // Only the first failure in a statement is reported. The rest of the statement is skipped, so
  // that all functions that are at work find its end.
  NodeId Fail(std::string message, std::string hint) {
    const bool reported = failed_ || Peek().kind == TokenKind::kBad;
    if (!reported) problems_.push_back({Peek().offset, std::move(message), std::move(hint)});
    failed_ = true;
    while (Peek().kind != TokenKind::kEnd && !Peek().Is(";")) Take();
    return Add({}, Peek());
  }

  NodeId Add(Node node, const Token& token) {
    node.offset = token.offset;
    for (const NodeId operand : node.operands) {
      node.depth = std::max<std::uint16_t>(node.depth, ast_.nodes[operand].depth + 1);
    }
    if (node.depth > kMaxOperators) {
      node.depth = 1;
      Fail("this expression has too many operators", "split it into several statements");
    }
    ast_.nodes.push_back(std::move(node));
    return static_cast<NodeId>(ast_.nodes.size() - 1);
  }
  NodeId Add(Operator op, std::vector<NodeId> operands, const Token& token) {
    Node node;
    node.op = op;
    node.operands = std::move(operands);
    return Add(std::move(node), token);
  }
  NodeId AddLiteral(Operand value, const Token& token) {
    Node node;
    node.value = value;
    return Add(std::move(node), token);
  }

  void Statement() {
    failed_ = false;
    const NodeId statement = Expression();
    ast_.statements.push_back(statement);
    const bool ends = Peek().kind == TokenKind::kEnd || Peek().Is(";");
    if (ends || (IsAssignment(ast_.nodes[statement].op) && AssignmentBegins())) return;
    std::string hint = HintForForeignOperator(Before(), Peek());
    if (hint.empty()) hint = "statements are separated by \";\"";
    Fail("expected an operator or \";\" before " + Quoted(Peek().text), std::move(hint));
  }

  // Two assignments need no semicolon between them.
  bool AssignmentBegins() const {
    return Peek().kind == TokenKind::kName && FindAssignment(Peek(1));
  }

  NodeId Expression() {
    const Level level(*this);
    if (level_ > kMaxDepth) return FailTooDeep();
    const NodeId left = Choice();
    const Operator* assignment = FindAssignment(Peek());
    if (!assignment || failed_) return left;
    if (ast_.nodes[left].op != Operator::kName) {
      return Fail("only a key can be assigned to",
                  Peek().Is("=")
                      ? "write == to compare"
                      : "on the left of " + Quoted(Peek().text) + " stands the name of a key");
    }
    const Token token = Take();
    ast_.nodes[left].is_target = true;
    const NodeId right = Expression();
    return Add(*assignment, {left, right}, token);
  }

  NodeId Choice() {
    const NodeId condition = Binary(kLowestPrecedence);
    if (!Peek().Is("?")) return condition;
    const Token token = Take();
    const NodeId yes = Expression();
    if (!Accept(":")) return Fail("expected \":\" and the other choice", "condition ? a : b");
    const NodeId no = Expression();
    return Add(Operator::kChoose, {condition, yes, no}, token);
  }

  NodeId Binary(int lowest) {
    NodeId left = Prefixed();
    while (const BinaryOperator* binary = FindBinary(Peek())) {
      if (binary->precedence < lowest) break;
      if (binary->op == Operator::kCompare) {
        left = Chain(left, binary->precedence);
        continue;
      }
      const Token token = Take();
      const NodeId right = Binary(binary->precedence + 1);
      left = Add(binary->op, {left, right}, token);
    }
    return left;
  }

  NodeId Chain(NodeId first, int precedence) {
    Node chain;
    chain.op = Operator::kCompare;
    chain.operands = {first};
    const Token token = Peek();
    while (const BinaryOperator* binary = FindBinary(Peek())) {
      if (binary->op != Operator::kCompare) break;
      Take();
      chain.relations.push_back(binary->relation);
      chain.operands.push_back(Binary(precedence + 1));
    }
    return Add(std::move(chain), token);
  }

  NodeId Prefixed() {
    const Operator* prefix = FindPrefix(Peek());
    if (!prefix) return Primary();
    const Level level(*this);
    if (level_ > kMaxDepth) return FailTooDeep();
    const Token token = Take();
    if (*prefix == Operator::kNegate && Peek().kind == TokenKind::kInteger) return Integer("-");
    const NodeId operand = Prefixed();
    return Add(*prefix, {operand}, token);
  }

  NodeId Primary() {
    const Token& token = Peek();
    switch (token.kind) {
      case TokenKind::kName:
        return Peek(1).Is("(") ? Call() : Name();
      case TokenKind::kInteger:
        return Integer("");
      case TokenKind::kReal:
        return Real();
      case TokenKind::kText:
        ast_.texts.push_back(Unquote(token.text));
        return AddLiteral(Operand::Text(ast_.texts.back()), Take());
      default:
        if (token.Is("(")) return Parenthesis();
        return FailNoOperand();
    }
  }

  NodeId FailNoOperand() {
    const Token& token = Peek();
    const bool ends = token.kind == TokenKind::kEnd || token.Is(";");
    const bool begins = at_ == 0 || Before().Is(";");
    const std::string what = begins ? "" : " after " + Quoted(Before().text);
    return Fail("expected a value" + what + (ends ? "" : ", not " + Quoted(token.text)),
                HintForForeignOperator(Before(), token));
  }

  NodeId FailTooDeep() {
    return Fail("the script is nested too deeply",
                "at most " + std::to_string(kMaxDepth) + " levels");
  }

  NodeId Name() {
    const Token& token = Take();
    if (token.text == "true" || token.text == "false") {
      return AddLiteral(Operand::Bool(token.text == "true"), token);
    }
    Node node;
    node.op = Operator::kName;
    node.name = token.text;
    return Add(std::move(node), token);
  }

  NodeId Integer(const std::string& sign) {
    const Token& token = Peek();
    const bool hexadecimal =
        token.text.size() > 1 && (token.text[1] == 'x' || token.text[1] == 'X');
    const std::string digits = sign + std::string(token.text.substr(hexadecimal ? 2 : 0));
    std::int64_t number = 0;
    const char* const end = digits.data() + digits.size();
    if (std::from_chars(digits.data(), end, number, hexadecimal ? 16 : 10).ec != std::errc()) {
      return Fail(sign + std::string(token.text) + " does not fit in 64 bits",
                  hexadecimal ? "" : "write " + sign + std::string(token.text) + ".0 for a double");
    }
    return AddLiteral(Operand::Integer(number), Take());
  }

  NodeId Real() {
    double number = 0;
    if (!ValueTraits<double>::Parse(Peek().text, number) || !std::isfinite(number)) {
      return Fail(std::string(Peek().text) + " is too large for a double", {});
    }
    return AddLiteral(Operand::Double(number), Take());
  }

  NodeId Parenthesis() {
    Take();
    const NodeId inner = Expression();
    return Accept(")") ? inner : FailNotClosed();
  }

  NodeId FailNotClosed() {
    std::string hint = HintForForeignOperator(Before(), Peek());
    return Fail(Peek().kind == TokenKind::kEnd || Peek().Is(";")
                    ? "expected \")\""
                    : "expected an operator or \")\" before " + Quoted(Peek().text),
                std::move(hint));
  }

  NodeId Call() {
    const Function* function = FindFunction(Peek().text);
    if (!function) {
      std::string hint = DidYouMean(Peek().text, FunctionNames());
      if (hint.empty()) hint = "the functions are abs, clamp, max and min";
      return Fail("unknown function " + Quoted(Peek().text), std::move(hint));
    }
    const Token token = Take();
    Take();
    std::vector<NodeId> arguments;
    while (!Peek().Is(")")) {
      arguments.push_back(Expression());
      if (!Accept(",")) break;
    }
    if (!Accept(")")) return FailNotClosed();
    if (arguments.size() < function->fewest || arguments.size() > function->most) {
      const bool open = function->most != function->fewest;
      at_ = IndexOf(token);
      return Fail(Quoted(token.text) + " takes " + std::to_string(function->fewest) +
                      (open ? " or more" : "") + " values, not " + std::to_string(arguments.size()),
                  {});
    }
    return Add(function->op, std::move(arguments), token);
  }

  std::size_t IndexOf(const Token& token) const {
    const auto is_before = [](const Token& a, const Token& b) { return a.offset < b.offset; };
    return std::lower_bound(tokens_.begin(), tokens_.end(), token, is_before) - tokens_.begin();
  }

  std::vector<ScriptProblem>& problems_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  Ast ast_;
  int level_ = 0;
  bool failed_ = false;
};

}  // namespace

Ast Parse(std::string_view script, std::vector<ScriptProblem>& problems) {
  return Parser(script, problems).Run();
}

}  // namespace coppice::script
