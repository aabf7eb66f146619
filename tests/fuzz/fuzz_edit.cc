#include <cstdlib>
#include <string>

#include "bt_core/model/attribute_edits.h"
#include "bt_core/model/element_edits.h"
#include "bt_core/model/strictness.h"
#include "bt_core/model/upgrade.h"
#include "tests/fuzz/fuzz_targets.h"

namespace coppice::fuzz {
namespace {

void Require(bool condition) {
  if (!condition) std::abort();
}

// Takes the choices of a run from the first bytes of the input.
class Choices {
 public:
  explicit Choices(std::string_view bytes) : bytes_(bytes) {}

  std::uint32_t Below(std::size_t limit) {
    if (bytes_.empty() || limit == 0) return 0;
    const auto byte = static_cast<unsigned char>(bytes_.front());
    bytes_.remove_prefix(1);
    return static_cast<std::uint32_t>(byte % limit);
  }

 private:
  std::string_view bytes_;
};

Edit ChooseEdit(const Document& document, Choices& choices) {
  const std::uint32_t kind = choices.Below(10);
  const ElementIndex element(choices.Below(document.elements().size()));
  const std::uint32_t number = choices.Below(4);
  const Element& e = document.element(element);
  const std::string name =
      e.attribute_count == 0
          ? "none"
          : std::string(document.attributes_begin(e)[number % e.attribute_count].name);
  switch (kind) {
    case 0:
      return SetAttribute(document, element, name, "<\"'&&\n{x}>");
    case 1:
      return SetAttribute(document, element, "fresh", "1");
    case 2:
      return RemoveAttribute(document, element, name);
    case 3:
      return SetTag(document, element, "Renamed");
    case 4:
      return InsertElement(document, element, number, "<N y='1'>\n  <M/>\n</N>");
    case 5:
      return RemoveElement(document, element);
    case 6:
      return MoveElement(document, element, ElementIndex(choices.Below(document.elements().size())),
                         number);
    case 7:
      return WrapElements(document, element, number, "W");
    case 8:
      return StrictXmlEdit(document);
    default:
      return UnwrapElement(document, element);
  }
}

void RequireOrdered(const Edit& edit, std::size_t size) {
  std::size_t at = 0;
  for (const Splice& splice : edit) {
    Require(splice.offset >= at);
    at = std::size_t{splice.offset} + splice.removed;
  }
  Require(at <= size);
}

void RequireUpgradable(const Document& document) {
  Diagnostics diagnostics;
  const Edit edit = UpgradeToFormat4(document, diagnostics);
  RequireOrdered(edit, document.text().size());
  Require(!diagnostics.has_errors());
  const auto upgraded = document.Rewritten(edit, diagnostics);
  Require(upgraded.has_value());
  Require(!IsFormat3(*upgraded));
  for (const Element& element : upgraded->elements()) upgraded->Location(element.offset);
}

}  // namespace

int FuzzEdit(std::string_view bytes) {
  constexpr std::size_t kChoices = 16;
  Choices choices(bytes.substr(0, kChoices));
  const std::string text(bytes.substr(std::min(kChoices, bytes.size())));
  Diagnostics diagnostics;
  std::optional<Document> document = Document::FromText(text, "", diagnostics);
  if (!document) return 0;
  Require(document->text() == text);
  RequireUpgradable(*document);

  std::vector<Edit> undo;
  for (int i = 0; i < 4; ++i) {
    const Edit edit = ChooseEdit(*document, choices);
    RequireOrdered(edit, document->text().size());
    std::optional<Document> edited = document->Edited(edit, diagnostics);
    if (!edited) break;  // nested too deep, or malformed behind what tinyxml2 reads
    undo.push_back(Inverse(edit, document->text()));
    document = std::move(edited);
  }
  const int done = static_cast<int>(undo.size());
  std::string restored = document->text();
  for (; !undo.empty(); undo.pop_back()) restored = Apply(undo.back(), restored);
  Require(restored == text);
  return 1 + done;
}

}  // namespace coppice::fuzz
