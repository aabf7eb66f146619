#include "bt_core/analysis/formats/tree_file.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "bt_core/model/attribute_edits.h"
#include "bt_core/model/document.h"
#include "bt_core/model/edit.h"
#include "bt_core/model/element_edits.h"

namespace coppice {
namespace {

void Append(Edit more, Edit& edit) {
  edit.insert(edit.end(), std::make_move_iterator(more.begin()),
              std::make_move_iterator(more.end()));
}

// What a robot of BehaviorTree.CPP writes into the tree that it sends. In the order of the text.
Edit WithoutMarks(const Document& document) {
  Edit edit;
  for (ElementIndex i = kRootElement; i < document.elements().size(); ++i) {
    for (const char* mark : {"_uid", "_fullpath"}) {
      Append(RemoveAttribute(document, i, mark), edit);
    }
  }
  std::sort(edit.begin(), edit.end(),
            [](const Splice& a, const Splice& b) { return a.offset < b.offset; });
  return edit;
}

class Joiner {
 public:
  explicit Joiner(const TreeDescription& tree) : tree_(tree) {}

  std::string Join() {
    std::optional<Document> first;
    std::string others;
    for (const DescribedDocument& described : tree_.documents) {
      std::optional<Document> document = Read(described.text);
      if (!document) continue;
      Apply(WithoutMarks(*document), *document);
      Apply(WithoutTheRest(*document), *document);
      if (first) {
        others += InnerOf(*document);
      } else {
        first = std::move(document);
      }
    }
    if (!first) return {};
    if (!others.empty()) Apply({{EndOfInner(*first), 0, others}}, *first);
    Apply(Named(*first), *first);
    return first->text();
  }

 private:
  std::optional<Document> Read(const std::string& text) {
    Diagnostics ignored;  // it was read before
    return Document::FromText(text, {}, ignored);
  }

  void Apply(const Edit& edit, Document& document) {
    if (edit.empty()) return;
    Diagnostics ignored;
    if (auto edited = document.Edited(edit, ignored)) document = *std::move(edited);
  }

  // Includes, for what they name is here; and trees that are here already.
  Edit WithoutTheRest(const Document& document) {
    Edit edit;
    for (ElementIndex i = document.element(kRootElement).first_child; i != kNoElement;
         i = document.element(i).next_sibling) {
      const Element& element = document.element(i);
      const std::string id(document.AttributeValue(element, "ID"));
      const bool is_known =
          element.tag == "BehaviorTree" && !id.empty() && !trees_.insert(id).second;
      const bool is_include = element.tag == "include" && tree_.documents.size() > 1;
      if (is_known || is_include) Append(RemoveElement(document, i), edit);
    }
    return edit;
  }

  // The only tree of a file needs no name, and nobody to say that it is the one to run.
  Edit Named(const Document& document) const {
    std::vector<ElementIndex> trees;
    const Element& root = document.element(kRootElement);
    for (ElementIndex i = root.first_child; i != kNoElement; i = document.element(i).next_sibling) {
      if (document.element(i).tag == "BehaviorTree") trees.push_back(i);
    }
    const std::string_view main = document.AttributeValue(root, "main_tree_to_execute");
    if (trees.size() < 2 || main == tree_.main_tree) return {};
    Edit edit = SetAttribute(document, kRootElement, "main_tree_to_execute", tree_.main_tree);
    for (const ElementIndex tree : trees) {
      if (document.FindAttribute(document.element(tree), "ID")) continue;
      Append(SetAttribute(document, tree, "ID", tree_.main_tree), edit);
    }
    return edit;
  }

  // Where the end tag of the root begins.
  static std::uint32_t EndOfInner(const Document& document) {
    const Element& root = document.element(kRootElement);
    if (root.is_self_closing()) return root.end;
    return static_cast<std::uint32_t>(document.text().rfind("</", root.end - 1));
  }

  // With the lines between, so that comments stay with what they are about.
  static std::string InnerOf(const Document& document) {
    const std::uint32_t begin = document.element(kRootElement).start_tag_end;
    const std::string inner = document.text().substr(begin, EndOfInner(document) - begin);
    return inner.substr(std::min(inner.find_first_not_of("\r\n"), inner.size()));
  }

  const TreeDescription& tree_;
  std::set<std::string> trees_;  // by ID, that are in the file
};

}  // namespace

std::string TreeFile(const TreeDescription& tree) { return Joiner(tree).Join(); }

}  // namespace coppice
