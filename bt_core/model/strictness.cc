#include "bt_core/model/strictness.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/model/markup.h"
#include "bt_core/model/utf8.h"
#include "bt_core/model/xml_text.h"

namespace coppice {
namespace {

enum class Laxity : std::uint8_t {
  kAmpersand,
  kLessThan,
  kDashes,
  kLateDeclaration,
  kTouching,
  kTag,
  kNotUtf8,
  kCutShort
};
struct Words {
  const char* message;
  const char* hint;
};
constexpr Words kWords[] = {
    {"'&' stands for itself; strict XML parsers refuse it", "write &amp;"},
    {"'<' stands for itself in a value; strict XML parsers refuse it", "write &lt;"},
    {"\"--\" in a comment; strict XML parsers refuse it", "write ="},
    {"blanks before <?xml ?>; strict XML parsers refuse them", "remove them"},
    {"no blank between two attributes; strict XML parsers refuse it", "insert a blank"},
    {"malformed tag; strict XML parsers refuse it", "write <Name or </Name>"},
    {"this is not UTF-8", "save the file as UTF-8"},
    {"what follows is ignored", "an end tag that closes nothing, or a zero byte"}};

struct Finding {
  Laxity kind;
  Splice fix;
};

class Finder {
 public:
  explicit Finder(const Document& document)
      : document_(document),
        text_(std::string_view(document.text()).substr(0, document.text().find('\0'))) {}

  std::vector<Finding> Run() {
    const std::size_t bad = FindInvalidUtf8(text_);
    if (bad < text_.size()) Add(Laxity::kNotUtf8, bad, 0, "");
    std::size_t at = 0;
    while (at < text_.size() && !IsCutShort(at)) {
      const Markup piece = ReadMarkup(text_, at);
      Check(piece);
      at = piece.end;
    }
    if (at < document_.text().size()) Add(Laxity::kCutShort, at, 0, "");
    return std::move(found_);
  }

 private:
  // Behind the root element, an end tag ends the document for tinyxml2.
  bool IsCutShort(std::size_t at) const {
    if (at < document_.element(kRootElement).end || text_[at] != '<') return false;
    return text_.substr(std::min(text_.find_first_not_of(kXmlBlanks, at + 1), text_.size() - 1),
                        1) == "/";
  }

  void Check(const Markup& piece) {
    switch (piece.kind) {
      case MarkupKind::kText:
        CheckCharacters(piece.begin, piece.end, false);
        break;
      case MarkupKind::kComment:
        CheckComment(piece);
        break;
      case MarkupKind::kInstruction:
        CheckDeclaration(piece);
        break;
      case MarkupKind::kTag:
        if (piece.begin < document_.element(kRootElement).end) CheckTag(piece);
        break;
      case MarkupKind::kCharacterData:
      case MarkupKind::kDocumentType:
        break;
    }
  }

  void CheckCharacters(std::size_t begin, std::size_t end, bool is_value) {
    for (std::size_t at = begin; at < end; ++at) {
      if (text_[at] == '&' && ReferenceLength(text_.substr(at, end - at)) == 0) {
        Add(Laxity::kAmpersand, at, 1, "&amp;");
      } else if (text_[at] == '<' && is_value) {
        Add(Laxity::kLessThan, at, 1, "&lt;");
      }
    }
  }

  // A comment must not hold two dashes in a row, nor end in a third.
  void CheckComment(const Markup& piece) {
    const std::size_t end = piece.end - std::string_view("-->").size();
    std::size_t at = piece.begin + std::string_view("<!--").size();
    while ((at = std::min(text_.find('-', at), end)) < end) {
      const std::size_t run = std::min(text_.find_first_not_of('-', at), end) - at;
      if (run > 1 || at + run == end) Add(Laxity::kDashes, at, run, std::string(run, '='));
      at += run;
    }
  }

  void CheckDeclaration(const Markup& piece) {
    const std::size_t first = text_.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0;
    const bool only_blanks = text_.find_first_not_of(kXmlBlanks, first) == piece.begin;
    if (only_blanks && piece.begin > first) {
      Add(Laxity::kLateDeclaration, first, piece.begin - first, "");
    }
  }

  void CheckTag(const Markup& piece) {
    const bool is_element =
        next_ < document_.elements().size() && document_.element(next_).offset == piece.begin;
    if (!is_element) {
      CheckEndTag(piece);
      return;
    }
    const Element& element = document_.element(next_++);
    const std::size_t name = element.tag.data() - document_.text().data();
    if (name != piece.begin + 1) Add(Laxity::kTag, piece.begin + 1, name - piece.begin - 1, "");
    std::size_t previous_end = 0;
    for (const Attribute* a = document_.attributes_begin(element);
         a != document_.attributes_end(element); ++a) {
      if (a->name_offset == previous_end) Add(Laxity::kTouching, previous_end, 0, " ");
      CheckCharacters(a->value_offset, a->value_end, true);
      previous_end = a->value_end + std::size_t{1};
    }
  }

  void CheckEndTag(const Markup& piece) {
    const std::size_t name = text_.find('/', piece.begin) + 1;
    const std::size_t name_end = text_.find_first_of(" \t\r\n\v\f>", name);
    const std::size_t rest = text_.find_first_not_of(kXmlBlanks, name_end);
    if (name == piece.begin + 2 && rest == piece.end - 1) return;
    Add(Laxity::kTag, piece.begin, piece.end - piece.begin,
        "</" + std::string(text_.substr(name, name_end - name)) + ">");
  }

  void Add(Laxity kind, std::size_t offset, std::size_t removed, std::string inserted) {
    found_.push_back({kind, Replacement(offset, offset + removed, std::move(inserted))});
  }

  const Document& document_;
  std::string_view text_;
  std::vector<Finding> found_;
  ElementIndex next_{0};
};

bool CanBeMended(const Finding& finding) {
  return finding.kind != Laxity::kNotUtf8 && finding.kind != Laxity::kCutShort;
}

}  // namespace

void WarnOfLaxXml(const Document& document, Diagnostics& diagnostics) {
  const std::vector<Finding> found = Finder(document).Run();
  for (std::size_t kind = 0; kind < std::size(kWords); ++kind) {
    const auto is = [kind](const Finding& f) { return static_cast<std::size_t>(f.kind) == kind; };
    const auto first = std::find_if(found.begin(), found.end(), is);
    if (first == found.end()) continue;
    const auto more = std::count_if(first + 1, found.end(), is);
    std::string hint = kWords[kind].hint;
    if (more > 0) hint += "; " + std::to_string(more) + " more in this file";
    diagnostics.Warning(document.Location(first->fix.offset), kWords[kind].message, hint);
  }
}

Edit StrictXmlEdit(const Document& document) {
  Edit edit;
  for (Finding& finding : Finder(document).Run()) {
    if (CanBeMended(finding)) edit.push_back(std::move(finding.fix));
  }
  return Merge(std::move(edit), {});  // in order
}

}  // namespace coppice
