// tinyxml2 names the line of an error, often one far behind the mistake, such as the end of the
// file. This reads a text that was refused once more, slowly, and with one aim: to name the place
// that a person would mend.
#include "bt_core/model/xml_error.h"

#include <tinyxml2.h>

#include <algorithm>
#include <vector>

#include "bt_core/model/markup.h"
#include "bt_core/model/xml_text.h"

namespace coppice {
namespace {

// tinyxml2 counts the document and the end tag as levels.
constexpr std::size_t kDeepest = TINYXML2_MAX_ELEMENT_DEPTH - 2;

std::string LineOf(std::string_view text, std::size_t offset) {
  const auto before = text.substr(0, offset);
  return std::to_string(std::count(before.begin(), before.end(), '\n') + 1);
}

std::string Tag(std::string_view name) { return "<" + std::string(name) + ">"; }

const char* Unclosed(MarkupKind kind) {
  switch (kind) {
    case MarkupKind::kComment:
      return "comment without -->";
    case MarkupKind::kCharacterData:
      return "CDATA without ]]>";
    case MarkupKind::kInstruction:
      return "<? without ?>";
    default:
      return "'<' without '>'";
  }
}

// Reads the inside of one tag, up to its first mistake.
class TagReader {
 public:
  TagReader(std::string_view text, std::size_t begin, std::size_t end)
      : text_(text), at_(begin), end_(end) {}

  std::string_view name() const { return name_; }
  bool is_end_tag() const { return is_end_tag_; }
  bool is_self_closing() const { return is_self_closing_; }

  std::optional<XmlError> Read() {
    ++at_;
    SkipBlanks();
    is_end_tag_ = Skip('/');
    name_ = ReadName();
    if (name_.empty()) {
      return XmlError{at_, "a name must follow '<'", "write &lt; for a '<' that stands for itself"};
    }
    std::optional<XmlError> error;
    std::vector<std::string_view> known;
    for (SkipBlanks(); !error && !AtClose(); SkipBlanks()) error = ReadAttribute(known);
    if (error && opened_at_ != std::string_view::npos) {
      return XmlError{opened_at_, "this value has no closing quote", ""};
    }
    return error;
  }

 private:
  char Now() const { return at_ < end_ ? text_[at_] : '\0'; }
  bool Skip(char c) {
    if (Now() != c) return false;
    ++at_;
    return true;
  }
  void SkipBlanks() { at_ = std::min(text_.find_first_not_of(kXmlBlanks, at_), end_); }

  std::string_view ReadName() {
    const std::size_t begin = at_;
    at_ += NameLength(text_.substr(begin, end_ - begin));
    return text_.substr(begin, at_ - begin);
  }

  bool AtClose() {
    if (Now() == '>') return true;
    is_self_closing_ = Now() == '/' && at_ + 1 < end_ && text_[at_ + 1] == '>';
    return is_self_closing_;
  }

  std::optional<XmlError> ReadAttribute(std::vector<std::string_view>& known) {
    const std::size_t begin = at_;
    const std::string_view name = ReadName();
    if (name.empty()) return Unexpected();
    const std::string quoted = "\"" + std::string(name) + "\"";
    SkipBlanks();
    if (!Skip('=')) {
      return XmlError{begin, "attribute " + quoted + " has no value",
                      "write " + std::string(name) + "=\"...\""};
    }
    SkipBlanks();
    const char quote = Now();
    if (quote != '"' && quote != '\'') return Unquoted(name);
    const std::size_t close = text_.find(quote, at_ + 1);
    if (close == std::string_view::npos || close >= end_) {
      return XmlError{at_, "the value of " + quoted + " has no closing quote", ""};
    }
    // A value with a tag in it is one whose closing quote is missing, if something is wrong at all.
    if (text_.substr(at_, close - at_).find("\n") != std::string_view::npos &&
        text_.substr(at_, close - at_).find('<') != std::string_view::npos) {
      opened_at_ = std::min(opened_at_, at_);
    }
    at_ = close + 1;
    if (std::find(known.begin(), known.end(), name) != known.end()) {
      return XmlError{begin, "second attribute " + quoted + " in the same element", "remove one"};
    }
    known.push_back(name);
    return std::nullopt;
  }

  XmlError Unquoted(std::string_view name) const {
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n/>", at_), end_);
    const std::string value(text_.substr(at_, end - at_));
    return {at_, "the value of \"" + std::string(name) + "\" must stand in quotes",
            "write " + std::string(name) + "=\"" + value + "\""};
  }

  XmlError Unexpected() const {
    if (Now() == '<') return {at_, Tag(name_) + " is not closed by '>' before this", ""};
    return {at_, std::string("unexpected '") + Now() + "' in " + Tag(name_),
            "expected attribute=\"value\" or '>'"};
  }

  std::string_view text_;
  std::size_t at_;
  std::size_t end_;
  std::string_view name_;
  std::size_t opened_at_ = std::string_view::npos;  // the quote of a suspicious value
  bool is_end_tag_ = false;
  bool is_self_closing_ = false;
};

class Checker {
 public:
  explicit Checker(std::string_view text) : text_(text) {}

  std::optional<XmlError> Run() {
    const std::size_t zero = text_.find('\0');
    if (zero != std::string_view::npos) {
      return XmlError{zero, "a zero byte", "is this a text file?"};
    }
    for (std::size_t at = 0; at < text_.size();) {
      const Markup piece = ReadMarkup(text_, at);
      if (auto error = Check(piece)) return error;
      at = piece.end;
    }
    if (open_.empty()) return std::nullopt;
    return XmlError{open_.back().offset, Tag(open_.back().name) + " is never closed",
                    "expected </" + std::string(open_.back().name) + ">"};
  }

 private:
  struct Open {
    std::string_view name;
    std::size_t offset;
  };

  std::optional<XmlError> Check(const Markup& piece) {
    if (piece.kind == MarkupKind::kText) return CheckText(piece);
    if (piece.kind == MarkupKind::kTag) return CheckTag(piece);
    if (!piece.is_closed) return XmlError{piece.begin, Unclosed(piece.kind), ""};
    const bool is_declaration = piece.kind == MarkupKind::kInstruction;
    if (is_declaration && seen_markup_) {
      return XmlError{piece.begin, "malformed or misplaced <?xml ?> declaration",
                      "it must come first in the file"};
    }
    seen_markup_ = true;
    return std::nullopt;
  }

  std::optional<XmlError> CheckText(const Markup& piece) const {
    const std::size_t words = text_.find_first_not_of(kXmlBlanks, piece.begin);
    if (!open_.empty() || !seen_root_ || words >= piece.end) return std::nullopt;
    return XmlError{words, "text outside of the root element", "put it in a comment"};
  }

  std::optional<XmlError> CheckTag(const Markup& piece) {
    TagReader tag(text_, piece.begin, piece.end);
    if (auto error = tag.Read()) return error;
    if (!piece.is_closed) return XmlError{piece.begin, Unclosed(piece.kind), ""};
    seen_markup_ = seen_root_ = true;
    if (tag.is_self_closing() && tag.is_end_tag()) {
      const std::string name(tag.name());
      return XmlError{piece.begin, "</" + name + "/> is neither a start tag nor an end tag",
                      "write <" + name + "/> or </" + name + ">"};
    }
    if (tag.is_self_closing()) return std::nullopt;
    if (tag.is_end_tag()) return Close(tag.name(), piece.begin);
    open_.push_back({tag.name(), piece.begin});
    if (open_.size() <= kDeepest) return std::nullopt;
    return XmlError{piece.begin,
                    "elements are nested more than " + std::to_string(kDeepest) + " deep",
                    "make the inner ones a SubTree"};
  }

  std::optional<XmlError> Close(std::string_view name, std::size_t offset) {
    const std::string end_tag = "</" + std::string(name) + ">";
    if (open_.empty()) return XmlError{offset, end_tag + " closes nothing", "remove it"};
    const Open last = open_.back();
    open_.pop_back();
    if (last.name == name) return std::nullopt;
    const bool closes_outer = std::any_of(open_.begin(), open_.end(),
                                          [name](const Open& open) { return open.name == name; });
    const std::string opened = Tag(last.name) + " of line " + LineOf(text_, last.offset);
    if (closes_outer) {
      return XmlError{offset, opened + " is not closed before " + end_tag,
                      "</" + std::string(last.name) + "> is missing"};
    }
    return XmlError{offset, end_tag + " does not close " + opened,
                    "expected </" + std::string(last.name) + ">"};
  }

  std::string_view text_;
  std::vector<Open> open_;
  bool seen_markup_ = false;
  bool seen_root_ = false;
};

}  // namespace

std::optional<XmlError> FindXmlError(std::string_view text) { return Checker(text).Run(); }

}  // namespace coppice
