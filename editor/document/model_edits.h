// The edits of <TreeNodesModel>: what a type of node is, as the user says it. Like
// bt_core/model/element_edits.h each is the bytes of one document that must change.
//
//   const ElementIndex model = FindModel(document, "Say");
//   Edit edit = model == kNoElement ? AddModel(document, {"Say", NodeCategory::kAction})
//                                   : AddPort(document, model, {"text", PortDirection::kInput});
#ifndef COPPICE_EDITOR_DOCUMENT_MODEL_EDITS_H_
#define COPPICE_EDITOR_DOCUMENT_MODEL_EDITS_H_

#include <string_view>

#include "bt_core/model/document.h"
#include "bt_core/model/node_model.h"

namespace coppice::editor {

/// The model of that ID, or kNoElement.
ElementIndex FindModel(const Document& document, std::string_view id);

/// Its port of that name, or kNoElement.
ElementIndex FindPort(const Document& document, ElementIndex model, std::string_view name);

/// Puts the model behind the others; makes a <TreeNodesModel> at the end of the file if there is
/// none.
Edit AddModel(const Document& document, const NodeModel& model);
/// The same with the XML of a model.
Edit AddModel(const Document& document, std::string_view xml);

/// Removes the model, and its <TreeNodesModel> if it is the only one in it.
Edit RemoveModel(const Document& document, ElementIndex model);

/// Says what the type is for: in the element that says it now, else in <MetadataFields>.
Edit DescribeModel(const Document& document, ElementIndex model, std::string_view description);

/// Puts the port behind the others.
Edit AddPort(const Document& document, ElementIndex model, const PortModel& port);

/// Makes the <input_port> or the like that port. Attributes that a PortModel does not know stay.
Edit ChangePort(const Document& document, ElementIndex element, const PortModel& port);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DOCUMENT_MODEL_EDITS_H_
