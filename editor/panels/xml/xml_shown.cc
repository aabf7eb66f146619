#include "editor/panels/xml/xml_shown.h"

#include "editor/document/fixes.h"

namespace coppice::editor {
namespace {

// Finds what is marked in the document in the text of its file, where that has other elements.
void Locate(const Workspace& workspace, const Document& document, ShownXml& shown) {
  const EditedFile* edited = workspace.project().Find(document.file());
  if (!workspace.file() || !edited || !edited->document) return;
  shown.begin = OffsetOf(*edited->document, document.Location(shown.begin));
  const ElementIndex element = edited->document->ElementAt(shown.begin);
  shown.end =
      element == kNoElement ? shown.begin : edited->document->element(element).start_tag_end;
}

}  // namespace

ShownXml ChooseXml(const EditorState& state, const TreeView* view) {
  const Workspace& workspace = state.workspace;
  ShownXml shown;
  const Forest* forest = workspace.forest();
  const OpenFile* file = workspace.file();
  if (file && (file->is_stale || !view)) {
    shown.path = file->path;
  } else if (forest && view) {
    const bool selected = view->selected() != kNoSceneNode;
    const SceneNode& node = view->scene()->nodes[selected ? view->selected() : 0];
    const Document& document = *forest->documents()[node.document];
    shown.path = document.file();
    shown.text = &document.text();
    shown.document = &document;
    const auto place = workspace.PlaceOf(node);
    const EditedFile* edited = place ? workspace.project().Find(place->path) : nullptr;
    const Document& text = edited ? *edited->document : document;
    if (selected) {
      const Element& element = text.element(place ? place->element : node.element);
      shown.begin = element.offset;
      shown.end = element.start_tag_end;
    }
    if (selected && !place) Locate(workspace, document, shown);
  }
  if (const EditedFile* edited = file ? workspace.project().Find(shown.path) : nullptr) {
    shown.text = &edited->text;
    shown.document = edited->document ? &*edited->document : nullptr;
    shown.can_edit = true;
  }
  return shown;
}

}  // namespace coppice::editor
