#include "bt_core/script/grammar.h"

#include <array>
#include <cstdint>
#include <utility>

namespace coppice::script {
namespace {

constexpr BinaryOperator kBinary[] = {
    {"||", 1, Operator::kOr},
    {"&&", 2, Operator::kAnd},
    {"==", 3, Operator::kCompare, Relation::kEqual},
    {"!=", 3, Operator::kCompare, Relation::kNotEqual},
    {"<", 3, Operator::kCompare, Relation::kLess},
    {"<=", 3, Operator::kCompare, Relation::kLessOrEqual},
    {">", 3, Operator::kCompare, Relation::kGreater},
    {">=", 3, Operator::kCompare, Relation::kGreaterOrEqual},
    {"|", 4, Operator::kBitOr},
    {"^", 4, Operator::kBitXor},
    {"&", 5, Operator::kBitAnd},
    {"+", 6, Operator::kAdd},
    {"-", 6, Operator::kSubtract},
    {"..", 6, Operator::kJoin},
    {"*", 7, Operator::kMultiply},
    {"/", 7, Operator::kDivide},
    {"%", 7, Operator::kRemainder},
};

struct Symbol {
  std::string_view symbol;
  Operator op;
};
constexpr Symbol kAssignments[] = {
    {":=", Operator::kCreate},       {"=", Operator::kAssign},      {"+=", Operator::kAddTo},
    {"-=", Operator::kSubtractFrom}, {"*=", Operator::kMultiplyBy}, {"/=", Operator::kDivideBy},
};
constexpr Symbol kPrefixes[] = {
    {"-", Operator::kNegate}, {"~", Operator::kComplement}, {"!", Operator::kNot}};

constexpr Function kFunctions[] = {
    {"abs", Operator::kAbsolute, 1, 1},
    {"clamp", Operator::kClamp, 3, 3},
    {"max", Operator::kMax, 2, SIZE_MAX},
    {"min", Operator::kMin, 2, SIZE_MAX},
};

template <class Table>
const Operator* Find(const Table& table, const Token& token) {
  for (const Symbol& entry : table) {
    if (token.Is(entry.symbol)) return &entry.op;
  }
  return nullptr;
}

}  // namespace

const BinaryOperator* FindBinary(const Token& token) {
  for (const BinaryOperator& entry : kBinary) {
    if (token.Is(entry.symbol)) return &entry;
  }
  return nullptr;
}

const Operator* FindAssignment(const Token& token) { return Find(kAssignments, token); }
const Operator* FindPrefix(const Token& token) { return Find(kPrefixes, token); }

const Function* FindFunction(std::string_view name) {
  for (const Function& function : kFunctions) {
    if (function.name == name) return &function;
  }
  return nullptr;
}

std::vector<std::string> FunctionNames() {
  std::vector<std::string> names;
  for (const Function& function : kFunctions) names.emplace_back(function.name);
  return names;
}

std::string_view SymbolOf(Operator op) {
  for (const BinaryOperator& entry : kBinary) {
    if (entry.op == op) return entry.symbol;
  }
  for (const Symbol& entry : kAssignments) {
    if (entry.op == op) return entry.symbol;
  }
  for (const Symbol& entry : kPrefixes) {
    if (entry.op == op) return entry.symbol;
  }
  for (const Function& function : kFunctions) {
    if (function.op == op) return function.name;
  }
  return "?:";
}

std::string HintForForeignOperator(const Token& before, const Token& token) {
  constexpr std::pair<std::string_view, const char*> kWords[] = {
      {"and", "&&"}, {"AND", "&&"}, {"or", "||"}, {"OR", "||"}, {"xor", "^"},
      {"mod", "%"},  {"is", "=="},  {"eq", "=="}, {"ne", "!="},
  };
  constexpr std::array<const char*, 3> kPairs[] = {
      {"==", "=", "write == to compare"},
      {"=", "=", "write == to compare"},
      {"!=", "=", "write != to compare"},
      {"=", ">", "write >="},
      {"=", "<", "write <="},
      {"<", ">", "write !="},
      {"+", "+", "write key += 1"},
      {"*", "*", "there is no operator for powers"},
  };
  for (const auto& [word, symbol] : kWords) {
    const bool is_word = token.kind == TokenKind::kName && token.text == word;
    if (is_word) return std::string("write ") + symbol;
  }
  for (const auto& [first, second, hint] : kPairs) {
    if (before.Is(first) && token.Is(second)) return hint;
  }
  const bool negates =
      before.kind == TokenKind::kName && (before.text == "not" || before.text == "NOT");
  return negates ? "write ! for \"not\"" : std::string();
}

}  // namespace coppice::script
