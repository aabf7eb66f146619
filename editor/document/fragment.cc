#include "editor/document/fragment.h"

#include <algorithm>
#include <optional>

#include "bt_core/model/layout.h"
#include "bt_core/model/xml_text.h"
#include "editor/document/draft.h"

namespace coppice::editor {
namespace {

constexpr char kSource[] = "clipboard";
constexpr std::string_view kOpen = "<clipboard>";
constexpr std::string_view kClose = "\n</clipboard>";

std::string TextOf(const Document& document, ElementIndex index) {
  const Element& element = document.element(index);
  return document.text().substr(element.offset, element.end - element.offset);
}

// Messages count from the user's own first column.
SourceLocation Shifted(SourceLocation where) {
  if (where.line == 1 && where.column > kOpen.size()) {
    where.column -= static_cast<std::uint32_t>(kOpen.size());
  }
  return where;
}

void AppendShifted(const Diagnostics& from, Diagnostics& to) {
  for (const Diagnostic& one : from.all()) {
    if (one.severity != Severity::kError) continue;
    to.Error(Shifted(one.where), one.message, one.hint, one.about);
  }
}

// A declaration is only allowed where a file starts.
std::string_view WithoutDeclaration(std::string_view text) {
  const std::size_t start = std::min(text.find_first_not_of(kXmlBlanks), text.size());
  if (text.compare(start, 5, "<?xml") != 0) return text;
  const std::size_t end = text.find("?>", start);
  return end == std::string_view::npos ? text : text.substr(end + 2);
}

class Reader {
 public:
  Reader(const Document& document, Diagnostics& diagnostics)
      : document_(document), diagnostics_(diagnostics) {}

  void ReadChildren(ElementIndex parent) {
    const Element& element = document_.element(parent);
    if (!document_.TextOf(element).empty()) Error(parent, "text between the nodes");
    for (ElementIndex i = element.first_child; i != kNoElement;
         i = document_.element(i).next_sibling) {
      Read(i);
    }
  }
  std::vector<std::string> fragments;

 private:
  void Read(ElementIndex index) {
    const std::string_view tag = document_.element(index).tag;
    if (tag == "root" || tag == "BehaviorTree") {
      ReadChildren(index);
    } else if (tag == "TreeNodesModel" || tag == "include") {
      if (document_.element(document_.element(index).parent).tag == "root") return;
      Error(index, "<" + std::string(tag) + "> is no node");
    } else {
      fragments.push_back(TextOf(document_, index));
    }
  }

  void Error(ElementIndex element, std::string message) {
    diagnostics_.Error(Shifted(document_.Location(document_.element(element).offset)),
                       std::move(message));
  }

  const Document& document_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::string CopyText(const Document& document, const std::vector<ElementIndex>& elements) {
  std::string text;
  for (const ElementIndex element : Topmost(document, elements)) {
    const auto indentation = IndentationAt(document.text(), document.element(element).offset);
    text += Reindent(TextOf(document, element), indentation.value_or(""), "", "\n");
    text += "\n";
  }
  return text;
}

std::vector<std::string> ReadFragments(std::string_view text, Diagnostics& diagnostics) {
  std::string wrapped(kOpen);
  wrapped += WithoutDeclaration(text);
  wrapped += kClose;
  Diagnostics problems;
  const auto document = Document::FromText(std::move(wrapped), kSource, problems);
  AppendShifted(problems, diagnostics);
  if (!document || problems.has_errors()) return {};
  if (document->element(kRootElement).end != document->text().size()) {
    diagnostics.Error({kSource, 0, 0}, "an end tag without its start tag");
    return {};
  }
  Diagnostics errors;
  Reader reader(*document, errors);
  reader.ReadChildren(kRootElement);
  if (reader.fragments.empty() && !errors.has_errors()) {
    errors.Error({kSource, 0, 0}, "there is no node in this text");
  }
  diagnostics.Append(errors);
  return errors.has_errors() ? std::vector<std::string>() : std::move(reader.fragments);
}

}  // namespace coppice::editor
