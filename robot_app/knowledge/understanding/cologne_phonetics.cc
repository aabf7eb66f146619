#include "robot_app/knowledge/understanding/phonetics.h"

namespace coppice::robot::knowledge {
namespace {

bool IsOneOf(char c, std::string_view letters) {
  return c != '\0' && letters.find(c) != std::string_view::npos;
}

// Of a C; `before` and `after` are its neighbours or 0.
char CodeOfC(char before, char after) {
  if (before == '\0') return IsOneOf(after, "ahkloqrux") ? '4' : '8';
  if (IsOneOf(before, "sz")) return '8';
  return IsOneOf(after, "ahkoqux") ? '4' : '8';
}

// The digits of a letter; empty if it has no sound.
std::string_view CodeOf(char before, char letter, char after) {
  if (IsOneOf(letter, "aeijouy")) return "0";
  if (letter == 'b') return "1";
  if (letter == 'p') return after == 'h' ? "3" : "1";
  if (IsOneOf(letter, "dt")) return IsOneOf(after, "csz") ? "8" : "2";
  if (IsOneOf(letter, "fvw")) return "3";
  if (IsOneOf(letter, "gkq")) return "4";
  if (letter == 'c') return CodeOfC(before, after) == '4' ? "4" : "8";
  if (letter == 'x') return IsOneOf(before, "ckq") ? "8" : "48";
  if (letter == 'l') return "5";
  if (IsOneOf(letter, "mn")) return "6";
  if (letter == 'r') return "7";
  if (IsOneOf(letter, "sz")) return "8";
  return "";
}

}  // namespace

std::string ColognePhonetics(std::string_view word) {
  std::string code;
  char last = '\0';
  for (std::size_t i = 0; i < word.size(); ++i) {
    const char before = i > 0 ? word[i - 1] : '\0';
    const char after = i + 1 < word.size() ? word[i + 1] : '\0';
    for (const char digit : CodeOf(before, word[i], after)) {
      if (digit != last && (digit != '0' || code.empty())) code += digit;
      last = digit;
    }
  }
  return code;
}

}  // namespace coppice::robot::knowledge
