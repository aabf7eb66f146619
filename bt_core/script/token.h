// The words of a script.
#ifndef COPPICE_BT_CORE_SCRIPT_TOKEN_H_
#define COPPICE_BT_CORE_SCRIPT_TOKEN_H_

#include <cstdint>
#include <string_view>
#include <vector>

#include "bt_core/script/script.h"

namespace coppice::script {

enum class TokenKind : std::uint8_t {
  kName,
  kInteger,  ///< 12 or 0x1F
  kReal,     ///< 1.5 or 1e-3
  kText,     ///< 'in quotes'
  kSymbol,   ///< an operator, parenthesis, comma or semicolon
  kBad,      ///< reported already
  kEnd
};

struct Token {
  TokenKind kind = TokenKind::kEnd;
  std::uint32_t offset = 0;
  std::string_view text;  ///< as written

  bool Is(std::string_view symbol) const { return kind == TokenKind::kSymbol && text == symbol; }
};

/// All tokens, with one of kind kEnd behind them. What is no token goes to the problems.
std::vector<Token> Tokenize(std::string_view script, std::vector<ScriptProblem>& problems);

/// The characters that a text in quotes stands for: \' \" \\ \n \t are one character each, any
/// other backslash is itself.
std::string Unquote(std::string_view quoted);

}  // namespace coppice::script

#endif  // COPPICE_BT_CORE_SCRIPT_TOKEN_H_
