#include "bt_core/script/token.h"

#include <array>
#include <string>
#include <utility>

namespace coppice::script {
namespace {

// Written out, because the functions of <cctype> depend on the locale.
bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsHexDigit(char c) { return IsDigit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }
bool IsNameStart(char c) {
  const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return letter || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}
bool IsNameCharacter(char c) { return IsNameStart(c) || IsDigit(c); }
bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

// Two characters before one.
constexpr std::array<std::string_view, 31> kSymbols = {
    ":=", "+=", "-=", "*=", "/=", "==", "!=", "<=", ">=", "&&", "||", "..", "+", "-", "*", "/",
    "%",  "&",  "|",  "^",  "~",  "!",  "<",  ">",  "=",  "?",  ":",  "(",  ")", ";", ","};

std::string HintForCharacter(char c) {
  switch (c) {
    case '{':
    case '}':
      return "in a script a key is written without braces";
    case '.':
      return "a key has no members; a number begins with a digit, as in 0.5; .. joins texts";
    case '@':
      return "write @key for a key of the main tree";
    default:
      return {};
  }
}

class Lexer {
 public:
  Lexer(std::string_view script, std::vector<ScriptProblem>& problems)
      : script_(script), problems_(problems) {}

  std::vector<Token> Run() {
    while (true) {
      SkipBlanks();
      const std::size_t start = at_;
      if (start >= script_.size()) break;
      const TokenKind kind = Next();
      Add(kind, start);
    }
    Add(TokenKind::kEnd, at_);
    return std::move(tokens_);
  }

 private:
  // '\0' behind the end.
  char Peek(std::size_t ahead = 0) const {
    return at_ + ahead < script_.size() ? script_[at_ + ahead] : '\0';
  }

  // A backslash before the end of a line is one, too: BehaviorTree.CPP 4.1 to 4.8 read it so.
  void SkipBlanks() {
    const auto ends_line = [](char c) { return c == '\n' || c == '\r'; };
    while (IsBlank(Peek()) || (Peek() == '\\' && ends_line(Peek(1)))) ++at_;
  }

  void Add(TokenKind kind, std::size_t start) {
    tokens_.push_back(
        {kind, static_cast<std::uint32_t>(start), script_.substr(start, at_ - start)});
  }

  TokenKind Next() {
    const char c = Peek();
    if (IsDigit(c)) return Number();
    if (IsNameStart(c) || (c == '@' && IsNameStart(Peek(1)))) {
      ++at_;
      while (IsNameCharacter(Peek())) ++at_;
      return TokenKind::kName;
    }
    if (c == '\'' || c == '"') return Text(c);
    return Symbol();
  }

  TokenKind Number() {
    const std::size_t start = at_;
    const bool hexadecimal = Peek() == '0' && (Peek(1) == 'x' || Peek(1) == 'X');
    const bool good = hexadecimal ? HexadecimalDigits() : DecimalDigits();
    const bool ends = !IsNameCharacter(Peek()) && !(Peek() == '.' && Peek(1) != '.');
    if (good && ends) return real_ ? TokenKind::kReal : TokenKind::kInteger;
    while (IsNameCharacter(Peek()) || Peek() == '.') ++at_;
    return Bad(start, "\"" + std::string(script_.substr(start, at_ - start)) + "\" is no number",
               "a text is written in quotes: 'text'");
  }

  bool HexadecimalDigits() {
    real_ = false;
    at_ += 2;
    return SkipDigits(IsHexDigit);
  }

  bool DecimalDigits() {
    real_ = false;
    SkipDigits(IsDigit);
    if (Peek() == '.' && IsDigit(Peek(1))) {
      real_ = true;
      ++at_;
      SkipDigits(IsDigit);
    }
    if (Peek() != 'e' && Peek() != 'E') return true;
    real_ = true;
    ++at_;
    if (Peek() == '+' || Peek() == '-') ++at_;
    return SkipDigits(IsDigit);
  }

  bool SkipDigits(bool (*is_digit)(char)) {
    const std::size_t start = at_;
    while (is_digit(Peek())) ++at_;
    return at_ > start;
  }

  TokenKind Text(char quote) {
    const std::size_t start = at_++;
    while (at_ < script_.size() && Peek() != quote) at_ += Peek() == '\\' ? 2 : 1;
    if (at_ < script_.size()) {
      ++at_;
      return TokenKind::kText;
    }
    at_ = script_.size();
    return Bad(start, "a text that begins here has no end",
               "close it with " + std::string(1, quote));
  }

  TokenKind Symbol() {
    for (const std::string_view symbol : kSymbols) {
      if (script_.substr(at_, symbol.size()) != symbol) continue;
      at_ += symbol.size();
      return TokenKind::kSymbol;
    }
    const char c = Peek();
    ++at_;
    const bool printable = c > ' ' && c < 0x7F;
    return Bad(at_ - 1,
               printable ? "unexpected \"" + std::string(1, c) + "\"" : "unexpected character",
               HintForCharacter(c));
  }

  TokenKind Bad(std::size_t offset, std::string message, std::string hint) {
    problems_.push_back({offset, std::move(message), std::move(hint)});
    return TokenKind::kBad;
  }

  std::string_view script_;
  std::vector<ScriptProblem>& problems_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  bool real_ = false;  // the last number has a fraction or an exponent
};

}  // namespace

std::vector<Token> Tokenize(std::string_view script, std::vector<ScriptProblem>& problems) {
  return Lexer(script, problems).Run();
}

std::string Unquote(std::string_view quoted) {
  const std::string_view inner = quoted.substr(1, quoted.size() - 2);
  std::string text;
  for (std::size_t i = 0; i < inner.size(); ++i) {
    const char next = i + 1 < inner.size() ? inner[i + 1] : '\0';
    const std::string_view escapes = "'\"\\nt";
    const std::size_t which = inner[i] == '\\' ? escapes.find(next) : std::string_view::npos;
    if (which == std::string_view::npos || next == '\0') {
      text += inner[i];
    } else {
      text += "'\"\\\n\t"[which];
      ++i;
    }
  }
  return text;
}

}  // namespace coppice::script
