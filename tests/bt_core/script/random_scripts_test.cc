// Thousands of random scripts, the same in every run, against an interpreter that walks the tree of
// the expression and knows nothing of slots, registers and jumps.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "tests/bt_core/script/fixture.h"

namespace coppice {
namespace {

using Datum = std::variant<bool, std::int64_t, double, std::string>;
using Memory = std::map<std::string, Datum>;

struct Error {};

struct Expression {
  std::string op;  // "" is a literal, "name" a key
  std::vector<Expression> operands;
  std::string text;
  Datum value;
};

bool IsText(const Datum& datum) { return std::holds_alternative<std::string>(datum); }
const std::string& TextOf(const Datum& datum) { return std::get<std::string>(datum); }

// Exact: it has 64 bits of mantissa.
long double NumberOf(const Datum& datum) {
  if (const bool* truth = std::get_if<bool>(&datum)) return *truth ? 1 : 0;
  if (const auto* integer = std::get_if<std::int64_t>(&datum)) return *integer;
  if (const double* number = std::get_if<double>(&datum)) return *number;
  throw Error();
}
bool IsWhole(const Datum& datum) {
  return std::holds_alternative<bool>(datum) || std::holds_alternative<std::int64_t>(datum);
}
std::int64_t BitsOf(const Datum& datum) {
  const long double number = NumberOf(datum);
  if (number != std::trunc(number) || number < -0x1p63L || number >= 0x1p63L) throw Error();
  return static_cast<std::int64_t>(number);
}
bool TruthOf(const Datum& datum) {
  if (!IsText(datum)) return NumberOf(datum) != 0;
  bool truth = false;
  double number = 0;
  if (ValueTraits<bool>::Parse(TextOf(datum), truth)) return truth;
  if (ValueTraits<double>::Parse(TextOf(datum), number)) return number != 0;
  throw Error();
}
std::string PrintOf(const Datum& datum) {
  return std::visit([](const auto& x) { return Value(x).Print(); }, datum);
}

Datum Arithmetic(const std::string& op, const Datum& a, const Datum& b) {
  const auto x = static_cast<double>(NumberOf(a));
  const auto y = static_cast<double>(NumberOf(b));
  if (op == "/") return x / y;
  if (op == "%" && y == 0) throw Error();
  if (IsWhole(a) && IsWhole(b)) {
    const __int128 i = BitsOf(a);
    const __int128 j = BitsOf(b);
    const __int128 exact = op == "+" ? i + j : op == "-" ? i - j : op == "*" ? i * j : i % j;
    if (exact == static_cast<std::int64_t>(exact)) return static_cast<std::int64_t>(exact);
  }
  return op == "+" ? x + y : op == "-" ? x - y : op == "*" ? x * y : std::fmod(x, y);
}

std::optional<Datum> ReadNumber(const std::string& text, bool as_truth) {
  bool truth = false;
  std::int64_t integer = 0;
  double number = 0;
  if (as_truth && ValueTraits<bool>::Parse(text, truth)) return truth;
  if (ValueTraits<std::int64_t>::Parse(text, integer)) return integer;
  if (ValueTraits<double>::Parse(text, number)) return number;
  return std::nullopt;
}

template <class T>
bool Relate(const std::string& op, const T& a, const T& b) {
  if (op == "==") return a == b;
  if (op == "!=") return a != b;
  if (op == "<") return a < b;
  if (op == "<=") return a <= b;
  return op == ">" ? a > b : a >= b;
}

bool Compare(const std::string& op, Datum a, Datum b) {
  if (IsText(a) && IsText(b)) return Relate(op, TextOf(a), TextOf(b));
  if (IsText(a) || IsText(b)) {
    Datum& text = IsText(a) ? a : b;
    const bool truth = std::holds_alternative<bool>(IsText(a) ? b : a);
    const std::optional<Datum> read = ReadNumber(TextOf(text), truth);
    if (!read && op != "==" && op != "!=") throw Error();
    if (!read) return op == "!=";
    text = *read;
  }
  return Relate(op, NumberOf(a), NumberOf(b));
}

Datum Converted(const Datum& before, const Datum& value) {
  if (IsText(before)) {
    if (!IsText(value)) throw Error();
    return value;
  }
  if (IsText(value)) {
    Value read;
    const Type& type = std::visit(
        [](const auto& x) -> const Type& { return TypeOf<std::decay_t<decltype(x)>>(); }, before);
    if (!read.Parse(type, TextOf(value))) throw Error();
    if (read.Is<bool>()) return read.Get<bool>();
    if (read.Is<double>()) return read.Get<double>();
    return read.Get<std::int64_t>();
  }
  const long double number = NumberOf(value);
  if (std::holds_alternative<double>(before)) return static_cast<double>(number);
  if (std::holds_alternative<bool>(before) && (number == 0 || number == 1)) return number == 1;
  const bool whole = number == std::trunc(number) && number >= -0x1p63L && number < 0x1p63L;
  if (std::holds_alternative<std::int64_t>(before) && whole) {
    return static_cast<std::int64_t>(number);
  }
  return value;
}

class Oracle {
 public:
  explicit Oracle(Memory memory) : memory_(std::move(memory)) {}
  const Memory& memory() const { return memory_; }

  Datum Evaluate(const Expression& e) {
    if (e.op.empty()) return e.value;
    if (e.op == "name") return Read(e.text);
    if (e.op == "&&") return Truth(e, 0) && Truth(e, 1);
    if (e.op == "||") return Truth(e, 0) || Truth(e, 1);
    if (e.op == "?:") return Evaluate(e.operands[Truth(e, 0) ? 1 : 2]);
    if (e.op == "chain") return Chain(e);
    if (e.op.back() == '=' && e.op.size() > 1 && e.op[0] != '=' && e.op[0] != '!' &&
        e.op[0] != '<' && e.op[0] != '>') {
      return Assign(e);
    }
    std::vector<Datum> data;
    for (const Expression& operand : e.operands) data.push_back(Evaluate(operand));
    return Apply(e.op, data);
  }

 private:
  bool Truth(const Expression& e, std::size_t k) { return TruthOf(Evaluate(e.operands[k])); }

  Datum Read(const std::string& name) {
    const auto found = memory_.find(name);
    if (found == memory_.end()) throw Error();
    return found->second;
  }

  // a < b <= c
  Datum Chain(const Expression& e) {
    Datum left = Evaluate(e.operands[0]);
    for (std::size_t i = 1; i < e.operands.size(); ++i) {
      const Datum right = Evaluate(e.operands[i]);
      if (!Compare(i == 1 ? "<" : "<=", left, right)) return false;
      left = right;
    }
    return true;
  }

  Datum Assign(const Expression& e) {
    const std::string& name = e.operands[0].text;
    const std::string op = e.op.substr(0, 1);
    Datum value;
    if (op == ":") {
      value = Evaluate(e.operands[1]);
    } else {
      const Datum before = Read(name);
      value = Apply(op, {before, Evaluate(e.operands[1])});
    }
    const auto found = memory_.find(name);
    memory_[name] = found == memory_.end() ? value : Converted(found->second, value);
    return memory_[name];
  }

  static Datum Apply(const std::string& op, const std::vector<Datum>& x) {
    if (op == "!") return !TruthOf(x[0]);
    if (op == "neg") {
      if (IsWhole(x[0])) return Arithmetic("-", std::int64_t{0}, x[0]);
      return -static_cast<double>(NumberOf(x[0]));
    }
    if (op == "~") return ~BitsOf(x[0]);
    if (op == "..") return PrintOf(x[0]) + PrintOf(x[1]);
    if (op == "+" && IsText(x[0]) && IsText(x[1])) return TextOf(x[0]) + TextOf(x[1]);
    if (op == "&") return BitsOf(x[0]) & BitsOf(x[1]);
    if (op == "|") return BitsOf(x[0]) | BitsOf(x[1]);
    if (op == "^") return BitsOf(x[0]) ^ BitsOf(x[1]);
    if (op == "min") return Number(NumberOf(x[1]) < NumberOf(x[0]) ? x[1] : x[0]);
    if (op == "max") return Number(NumberOf(x[1]) > NumberOf(x[0]) ? x[1] : x[0]);
    if (op == "abs") return std::signbit(NumberOf(x[0])) ? Apply("neg", x) : Number(x[0]);
    if (op == "clamp") {
      if (NumberOf(x[1]) > NumberOf(x[2])) throw Error();
      return Apply("min", {Apply("max", {x[0], x[1]}), x[2]});
    }
    if (op == "+" || op == "-" || op == "*" || op == "/" || op == "%") {
      return Arithmetic(op, x[0], x[1]);
    }
    return Compare(op, x[0], x[1]);
  }

  static Datum Number(const Datum& datum) {
    if (!std::holds_alternative<bool>(datum)) return datum;
    return std::int64_t{std::get<bool>(datum)};
  }

  Memory memory_;
};

// Writes an expression with no more parentheses than it needs, and some more by chance.
class Writer {
 public:
  explicit Writer(std::mt19937& random) : random_(random) {}

  std::string Write(const Expression& e, int lowest = 0) {
    const int precedence = PrecedenceOf(e);
    const bool needed = precedence < lowest;
    std::string text = Plain(e, precedence);
    return needed || random_() % 8 == 0 ? "(" + text + ")" : text;
  }

 private:
  static int PrecedenceOf(const Expression& e) {
    static const std::map<std::string, int> kLevels = {
        {":=", 1},    {"+=", 1}, {"-=", 1}, {"*=", 1}, {"/=", 1}, {"?:", 2},  {"||", 3},
        {"&&", 4},    {"==", 5}, {"!=", 5}, {"<", 5},  {"<=", 5}, {">", 5},   {">=", 5},
        {"chain", 5}, {"|", 6},  {"^", 6},  {"&", 7},  {"+", 8},  {"-", 8},   {"..", 8},
        {"*", 9},     {"/", 9},  {"%", 9},  {"!", 10}, {"~", 10}, {"neg", 10}};
    const auto found = kLevels.find(e.op);
    return found == kLevels.end() ? 11 : found->second;
  }

  std::string Plain(const Expression& e, int level) {
    const auto operand = [&](std::size_t k, int lowest) { return Write(e.operands[k], lowest); };
    if (e.op.empty() || e.op == "name") return e.text;
    if (level == 1) return operand(0, 11) + " " + e.op + " " + operand(1, 1);
    if (e.op == "?:") return operand(0, 3) + " ? " + operand(1, 1) + " : " + operand(2, 1);
    if (e.op == "chain") {
      return operand(0, 6) + " < " + operand(1, 6) + " <= " + operand(2, 6);
    }
    if (level == 10) return (e.op == "neg" ? "-" : e.op) + operand(0, 10);
    if (level == 11) {
      std::string text = e.op + "(";
      for (std::size_t i = 0; i < e.operands.size(); ++i) text += (i ? ", " : "") + operand(i, 1);
      return text + ")";
    }
    const int left = level == 5 ? 6 : level;  // two relations in a row would make a chain
    return operand(0, left) + " " + e.op + " " + operand(1, level + 1);
  }

  std::mt19937& random_;
};

class Maker {
 public:
  explicit Maker(std::mt19937& random) : random_(random) {}

  Expression Make(int depth) {
    static const std::vector<std::string> kBinary = {
        "&&", "||", "==", "!=", "<", "<=", ">", ">=", "&",  "|",  "^",   "+",
        "-",  "..", "*",  "/",  "%", "+",  "-", "*",  "&&", "||", "min", "max"};
    const unsigned choice = depth == 0 ? random_() % 4 : random_() % 24;
    if (choice < 2) return Literal();
    if (choice < 4) return Name();
    if (choice < 6) return Node(Pick({"!", "neg", "~", "abs"}), 1, depth);
    if (choice == 6) return Node("?:", 3, depth);
    if (choice == 7) return Node("chain", 3, depth);
    if (choice == 8) return Node("clamp", 3, depth);
    if (choice == 9) {
      Expression assignment = Node(Pick({":=", ":=", "+=", "-=", "*=", "/="}), 2, depth);
      assignment.operands[0] = Name();
      return assignment;
    }
    return Node(Pick(kBinary), 2, depth);
  }

 private:
  std::string Pick(const std::vector<std::string>& names) {
    return names[random_() % names.size()];
  }

  Expression Literal() {
    static const std::vector<std::pair<std::string, Datum>> kLiterals = {
        {"0", std::int64_t{0}},
        {"1", std::int64_t{1}},
        {"2", std::int64_t{2}},
        {"7", std::int64_t{7}},
        {"0x1F", std::int64_t{31}},
        {"9223372036854775807", std::int64_t{9223372036854775807}},
        {"9007199254740993", std::int64_t{9007199254740993}},
        {"0.5", 0.5},
        {"2.0", 2.0},
        {"1e300", 1e300},
        {"9007199254740992.0", 9007199254740992.0},
        {"true", true},
        {"false", false},
        {"'5'", std::string("5")},
        {"''", std::string()},
        {"'a b'", std::string("a b")},
        {"'true'", std::string("true")},
        {"'it\\'s'", std::string("it's")}};
    const auto& [text, value] = kLiterals[random_() % kLiterals.size()];
    return {"", {}, text, value};
  }

  Expression Name() {
    return {"name", {}, Pick({"i", "j", "d", "b", "s", "long_text", "unset"}), {}};
  }

  Expression Node(const std::string& op, int count, int depth) {
    Expression node{op, {}, "", {}};
    for (int i = 0; i < count; ++i) node.operands.push_back(Make(depth - 1));
    return node;
  }

  std::mt19937& random_;
};

std::string Show(const Datum& datum) {
  return std::visit(
      [](const auto& x) {
        return std::string(TypeOf<std::decay_t<decltype(x)>>().name) + " " + Value(x).Print();
      },
      datum);
}

bool HasTruth(const Expression& e, const Memory& memory) {
  try {
    TruthOf(Oracle(memory).Evaluate(e));
  } catch (const Error&) {
    return false;
  }
  return true;
}

// Does any part of the expression fail, if it is evaluated?
bool HasError(const Expression& e, const Memory& memory) {
  try {
    Oracle(memory).Evaluate(e);
  } catch (const Error&) {
    return true;
  }
  const bool wants_truth = e.op == "&&" || e.op == "||" || e.op == "!" || e.op == "?:";
  for (std::size_t i = 0; i < e.operands.size(); ++i) {
    if (HasError(e.operands[i], memory)) return true;
    if (wants_truth && (i == 0 || e.op != "?:") && !HasTruth(e.operands[i], memory)) return true;
  }
  return false;
}

const Memory& StartMemory() {
  static const Memory memory = {
      {"i", std::int64_t{3}},      {"j", std::int64_t{-40}},           {"d", 2.5}, {"b", true},
      {"s", std::string("words")}, {"long_text", std::string(60, 'x')}};
  return memory;
}

TEST(RandomScripts, GiveWhatTheOracleGives) {
  std::mt19937 random(20240501);
  int values = 0;
  int errors = 0;
  int refused = 0;
  for (int round = 0; round < 20000; ++round) {
    const Expression e = Maker(random).Make(1 + round % 5);
    const std::string text = Writer(random).Write(e);
    SCOPED_TRACE(text);

    Oracle oracle(StartMemory());
    std::string expected = "error";
    try {
      expected = Show(oracle.Evaluate(e));
    } catch (const Error&) {
    }

    ScriptBench bench;
    for (const auto& [name, datum] : StartMemory()) {
      std::visit([&bench, key = name](const auto& x) { bench.Set(key, x); }, datum);
    }
    if (!bench.ProblemsOf(text).empty()) {
      ++refused;
      ASSERT_TRUE(HasError(e, StartMemory())) << bench.ProblemsOf(text)[0].message;
      continue;
    }
    ASSERT_EQ(bench.ResultOf(text), expected);
    for (const auto& [name, datum] : oracle.memory())
      ASSERT_EQ(bench.Show(name), Show(datum)) << name;
    ++(expected == "error" ? errors : values);

    // The same as a condition.
    std::optional<bool> truth;
    try {
      truth = TruthOf(Oracle(oracle.memory()).Evaluate(e));
    } catch (const Error&) {
    }
    try {
      ASSERT_EQ(std::optional<bool>(bench.Test(text)), truth);
    } catch (const ScriptError& error) {
      ASSERT_EQ(truth, std::nullopt) << error.what();
    }
  }
  EXPECT_GT(values, 5000);
  EXPECT_GT(errors, 500);
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace coppice
