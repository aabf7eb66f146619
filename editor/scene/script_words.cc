#include "editor/scene/script_words.h"

#include <algorithm>

#include "bt_core/script/token.h"

namespace coppice::editor {
namespace {

using script::Token;

bool IsUpdate(const Token& token) {
  return token.Is("+=") || token.Is("-=") || token.Is("*=") || token.Is("/=");
}

}  // namespace

std::vector<ScriptWord> WordsOf(std::string_view script) {
  std::vector<ScriptProblem> problems;
  const std::vector<Token> tokens = script::Tokenize(script, problems);
  std::vector<ScriptWord> words;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    const bool is_name = token.kind == script::TokenKind::kName;
    if (!is_name || token.text == "true" || token.text == "false") continue;
    const Token& next = tokens[std::min(i + 1, tokens.size() - 1)];
    const bool writes = next.Is(":=") || next.Is("=") || IsUpdate(next);
    words.push_back({std::string(token.text), token.offset, !writes || IsUpdate(next), writes});
  }
  return words;
}

}  // namespace coppice::editor
