#include <cstddef>

#include "robot_app/knowledge/understanding/phonetics.h"

namespace coppice::robot::knowledge {
namespace {

// What a group of letters sounds like. The first rule that fits is taken. `before` and `after` are
// letters of which one must stand there: '^' is the beginning, '$' the end; empty: anything.
struct Rule {
  std::string_view letters;
  std::string_view before, after;
  std::string_view primary, other;
};

constexpr std::string_view kVowels = "aeiouy";
constexpr std::string_view kVowelsOrStart = "^aeiouy";

constexpr Rule kRules[] = {
    {"gn", "^", "", "N", "N"},
    {"kn", "^", "", "N", "N"},
    {"pn", "^", "", "N", "N"},
    {"wr", "^", "", "R", "R"},
    {"ps", "^", "", "S", "S"},
    {"x", "^", "", "S", "S"},
    {"bb", "", "", "P", "P"},
    {"mb", "", "$", "M", "M"},
    {"b", "", "", "P", "P"},
    {"tch", "", "", "X", "X"},
    {"sch", "", "o", "SK", "SK"},
    {"sch", "", "lmnrw", "X", "S"},
    {"sch", "", "", "X", "SK"},
    {"chr", "^", "", "KR", "KR"},
    {"cha", "^", "r", "K", "X"},
    {"chem", "^", "", "KM", "KM"},
    {"cho", "^", "r", "K", "K"},
    {"ch", "", "", "X", "K"},
    {"cia", "", "", "X", "X"},
    {"cz", "", "", "S", "X"},
    {"cc", "", "ei", "KS", "KS"},
    {"cc", "", "", "K", "K"},
    {"ck", "", "", "K", "K"},
    {"cg", "", "", "K", "K"},
    {"cq", "", "", "K", "K"},
    {"c", "", "iey", "S", "S"},
    {"c", "", "", "K", "K"},
    {"dg", "", "eiy", "J", "J"},
    {"dt", "", "", "T", "T"},
    {"dd", "", "", "T", "T"},
    {"d", "", "", "T", "T"},
    {"ff", "", "", "F", "F"},
    {"f", "", "", "F", "F"},
    {"gh", "^", "", "K", "K"},
    {"augh", "", "", "F", ""},
    {"ough", "", "", "F", ""},
    {"gh", "aeiouy", "", "", ""},
    {"gh", "", "", "K", "K"},
    {"gn", "", "$", "N", "KN"},
    {"gg", "", "", "K", "K"},
    {"g", "", "eiy", "J", "K"},
    {"g", "", "", "K", "K"},
    {"h", kVowelsOrStart, kVowels, "H", "H"},
    {"jj", "", "", "J", "J"},
    {"j", "^", "", "J", "A"},
    {"j", "", "", "J", "H"},
    {"kk", "", "", "K", "K"},
    {"k", "", "", "K", "K"},
    {"q", "", "", "K", "K"},
    {"ll", "", "", "L", "L"},
    {"l", "", "", "L", "L"},
    {"mm", "", "", "M", "M"},
    {"m", "", "", "M", "M"},
    {"nn", "", "", "N", "N"},
    {"n", "", "", "N", "N"},
    {"ph", "", "", "F", "F"},
    {"pp", "", "", "P", "P"},
    {"p", "", "", "P", "P"},
    {"rr", "", "", "R", "R"},
    {"r", "", "", "R", "R"},
    {"sh", "", "", "X", "X"},
    {"sio", "", "", "S", "X"},
    {"sia", "", "", "S", "X"},
    {"sz", "", "", "S", "X"},
    {"s", "^", "lmnw", "S", "X"},
    {"sc", "", "iey", "S", "S"},
    {"ss", "", "", "S", "S"},
    {"s", "", "", "S", "S"},
    {"tion", "", "", "XN", "XN"},
    {"tia", "", "", "X", "X"},
    {"tth", "", "", "0", "T"},
    {"th", "", "", "0", "T"},
    {"tz", "", "", "TS", "TS"},
    {"tt", "", "", "T", "T"},
    {"t", "", "", "T", "T"},
    {"vv", "", "", "F", "F"},
    {"v", "", "", "F", "F"},
    {"wicz", "", "", "TS", "FX"},
    {"wh", "^", "", "A", "A"},
    {"w", "^", kVowels, "A", "F"},
    {"w", kVowels, "$", "", "F"},
    {"x", "", "", "KS", "KS"},
    {"zh", "", "", "J", "J"},
    {"zz", "", "", "S", "TS"},
    {"z", "", "", "S", "TS"},
    {"a", "^", "", "A", "A"},
    {"e", "^", "", "A", "A"},
    {"i", "^", "", "A", "A"},
    {"o", "^", "", "A", "A"},
    {"u", "^", "", "A", "A"},
    {"y", "^", "", "A", "A"},
};

bool Fits(const Rule& rule, std::string_view word, std::size_t at) {
  if (word.substr(at, rule.letters.size()) != rule.letters) return false;
  const std::size_t end = at + rule.letters.size();
  const char before = at == 0 ? '^' : word[at - 1];
  const char after = end == word.size() ? '$' : word[end];
  return (rule.before.empty() || rule.before.find(before) != std::string_view::npos) &&
         (rule.after.empty() || rule.after.find(after) != std::string_view::npos);
}

}  // namespace

MetaphoneCodes DoubleMetaphone(std::string_view word) {
  MetaphoneCodes codes;
  for (std::size_t at = 0; at < word.size();) {
    std::size_t length = 1;
    for (const Rule& rule : kRules) {
      if (!Fits(rule, word, at)) continue;
      codes.primary += rule.primary;
      codes.other += rule.other;
      length = rule.letters.size();
      break;
    }
    at += length;
  }
  return codes;
}

}  // namespace coppice::robot::knowledge
