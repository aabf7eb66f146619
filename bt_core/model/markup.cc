#include "bt_core/model/markup.h"

namespace coppice {
namespace {

struct Bracket {
  std::string_view open;
  std::string_view close;
  MarkupKind kind;
};
constexpr Bracket kBrackets[] = {{"<!--", "-->", MarkupKind::kComment},
                                 {"<![CDATA[", "]]>", MarkupKind::kCharacterData},
                                 {"<?", "?>", MarkupKind::kInstruction},
                                 {"<!", ">", MarkupKind::kDocumentType}};

// The '>' that closes a tag, or npos.
std::size_t FindTagClose(std::string_view text, std::size_t at) {
  constexpr const char* kSpecial = ">\"'";
  std::size_t found = text.find_first_of(kSpecial, at);
  while (found != std::string_view::npos && text[found] != '>') {
    const std::size_t closing_quote = text.find(text[found], found + 1);
    if (closing_quote == std::string_view::npos) return closing_quote;
    found = text.find_first_of(kSpecial, closing_quote + 1);
  }
  return found;
}

Markup UpTo(MarkupKind kind, std::string_view text, std::size_t begin, std::size_t close,
            std::size_t length) {
  if (close == std::string_view::npos) return {kind, begin, text.size(), false};
  return {kind, begin, close + length, true};
}

}  // namespace

Markup ReadMarkup(std::string_view text, std::size_t at) {
  if (text[at] != '<') {
    const std::size_t end = text.find('<', at);
    return {MarkupKind::kText, at, end == std::string_view::npos ? text.size() : end, true};
  }
  for (const Bracket& bracket : kBrackets) {
    if (text.substr(at, bracket.open.size()) != bracket.open) continue;
    const std::size_t close = text.find(bracket.close, at + bracket.open.size());
    return UpTo(bracket.kind, text, at, close, bracket.close.size());
  }
  return UpTo(MarkupKind::kTag, text, at, FindTagClose(text, at), 1);
}

}  // namespace coppice
