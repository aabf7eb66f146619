#include "editor/document/search_pattern.h"

#include <algorithm>
#include <regex>

namespace coppice::editor {

struct SearchPattern::Expression {
  std::regex regex;
};

namespace {

char Small(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string InSmallLetters(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(), Small);
  return small;
}

std::regex::flag_type Flags(bool fold_case) {
  auto flags = std::regex::ECMAScript;
#ifdef __GLIBCXX__
  // Otherwise the library calls itself for every character, until the stack is full.
  flags |= std::regex_constants::__polynomial;
#endif
  if (fold_case) flags |= std::regex::icase;
  return flags;
}

}  // namespace

SearchPattern SearchPattern::Literal(std::string_view text, bool fold_case) {
  SearchPattern pattern;
  pattern.literal_ = fold_case ? InSmallLetters(text) : std::string(text);
  pattern.fold_case_ = fold_case;
  return pattern;
}

std::optional<SearchPattern> SearchPattern::Regular(std::string_view text, bool fold_case) {
  if (text.size() > kLongestExpression) return std::nullopt;
  try {
    SearchPattern pattern;
    pattern.expression_ = std::make_shared<Expression>(
        Expression{std::regex(text.begin(), text.end(), Flags(fold_case))});
    return pattern;
  } catch (const std::regex_error&) {
    return std::nullopt;
  }
}

std::vector<SearchPattern::Found> SearchPattern::In(std::string_view text,
                                                    const std::string& with) const {
  return expression_ ? FindExpression(text, with) : FindLiteral(text, with);
}

std::vector<SearchPattern::Found> SearchPattern::FindLiteral(std::string_view text,
                                                             const std::string& with) const {
  const auto same = [this](char in_text, char in_pattern) {
    return (fold_case_ ? Small(in_text) : in_text) == in_pattern;
  };
  std::vector<Found> found;
  auto from = text.begin();
  while (true) {
    const auto at = std::search(from, text.end(), literal_.begin(), literal_.end(), same);
    if (at == text.end()) return found;
    const auto begin = static_cast<std::size_t>(at - text.begin());
    found.push_back({begin, begin + literal_.size(), with});
    from = at + static_cast<std::ptrdiff_t>(literal_.size());
  }
}

std::vector<SearchPattern::Found> SearchPattern::FindExpression(std::string_view text,
                                                                const std::string& with) const {
  std::vector<Found> found;
  text = text.substr(0, kLongestText);
  try {
    using Iterator = std::cregex_iterator;
    for (Iterator i(text.data(), text.data() + text.size(), expression_->regex); i != Iterator();
         ++i) {
      if (i->length() == 0) continue;
      const auto begin = static_cast<std::size_t>(i->position());
      found.push_back({begin, begin + static_cast<std::size_t>(i->length()), i->format(with)});
    }
  } catch (const std::regex_error&) {  // another library gives up on what takes too long
  }
  return found;
}

}  // namespace coppice::editor
