// A change in the making: a copy of a document to which edits are applied one after the other, and
// the elements that it is about, which are followed through the edits.
//
//   Draft draft(document, {sequence});
//   draft.Apply(InsertElement(draft.document(), draft.selected(0), 0, "<Beep/>"));
//   FileChange change = std::move(draft).Finish("patrol.xml");   // change.h
//
// Elements are followed by the offset of their '<'.
#ifndef COPPICE_EDITOR_DOCUMENT_DRAFT_H_
#define COPPICE_EDITOR_DOCUMENT_DRAFT_H_

#include <cstdint>
#include <string>
#include <vector>

#include "bt_core/model/document.h"
#include "editor/files/change.h"

namespace coppice::editor {

class Draft {
 public:
  explicit Draft(Document document, const std::vector<ElementIndex>& selection = {});

  const Document& document() const { return document_; }

  /// Applies an edit of document(); false if the result is malformed, then nothing has changed and
  /// problems() says why. An empty edit is fine.
  bool Apply(const Edit& edit);

  /// Moves the element with all that is in it, as MoveElement does; if it is selected, it stays so.
  bool Move(ElementIndex element, ElementIndex new_parent, std::uint32_t position);

  /// What stood in the way of the edits that were refused.
  const Diagnostics& problems() const { return problems_; }

  /// The followed elements as they are numbered now, in document order, without those that are
  /// gone.
  std::vector<ElementIndex> selection() const;
  void Select(const std::vector<ElementIndex>& elements);

  /// True if an edit has changed a byte.
  bool has_changed() const { return !steps_.empty(); }

  FileChange Finish(std::string path) &&;

 private:
  Document document_;
  std::vector<Edit> steps_;
  std::vector<std::uint32_t> offsets_;  // of the selection
  Diagnostics problems_;
};

/// Without the elements that lie in others of the list; in document order, each once.
std::vector<ElementIndex> Topmost(const Document& document, std::vector<ElementIndex> elements);

/// Its number among the element children of its parent, from 0.
std::uint32_t PositionOf(const Document& document, ElementIndex element);

/// The sibling before it, or kNoElement.
ElementIndex SiblingBefore(const Document& document, ElementIndex element);

/// The child at that position, or the last; kNoElement if there are none.
ElementIndex ChildAt(const Document& document, ElementIndex parent, std::uint32_t position);

/// True if `inner` lies in `outer` or is the same.
bool LiesIn(const Document& document, ElementIndex inner, ElementIndex outer);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DOCUMENT_DRAFT_H_
