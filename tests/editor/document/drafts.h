// Drafts of small texts, and elements by what they are called.
#ifndef COPPICE_TESTS_EDITOR_DOCUMENT_DRAFTS_H_
#define COPPICE_TESTS_EDITOR_DOCUMENT_DRAFTS_H_

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "editor/document/draft.h"
#include "editor/document/node_rules.h"

namespace coppice::editor {

inline Document Parsed(const std::string& text) {
  Diagnostics diagnostics;
  auto document = Document::FromText(text, "test.xml", diagnostics);
  if (!document) throw std::invalid_argument(diagnostics.ToString());
  return *std::move(document);
}

/// The first element of that name, else of that tag.
inline ElementIndex Find(const Document& document, const std::string& name) {
  for (const bool by_name : {true, false}) {
    for (ElementIndex i{0}; i < document.elements().size(); ++i) {
      const Element& element = document.element(i);
      if ((by_name ? document.AttributeValue(element, "name") : element.tag) == name) return i;
    }
  }
  ADD_FAILURE() << "no element " << name;
  return kRootElement;
}

inline Draft DraftOf(const Document& document, const std::vector<std::string>& names) {
  std::vector<ElementIndex> selection;
  for (const std::string& name : names) selection.push_back(Find(document, name));
  return Draft(document, selection);
}

/// The names of what is selected.
inline std::vector<std::string> Selected(const Draft& draft) {
  std::vector<std::string> names;
  for (const ElementIndex element : draft.selection()) {
    names.emplace_back(NameOf(draft.document(), element));
  }
  return names;
}

inline constexpr char kRound[] = R"(<root BTCPP_format="4">
  <BehaviorTree ID="Main">
    <Sequence name="top">
      <A/>
      <!-- about B -->
      <B goal="{goal}"/> <!-- behind B -->
      <Fallback name="inner">
        <C msec='5'/>
        <D/>
      </Fallback>
    </Sequence>
  </BehaviorTree>
  <TreeNodesModel>
    <Action ID="A"/>
    <Action ID="B"><input_port name="goal"/></Action>
    <Action ID="C"><input_port name="msec"/></Action>
    <Action ID="Go"><input_port name="goal"/></Action>
  </TreeNodesModel>
</root>
)";

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_DOCUMENT_DRAFTS_H_
