// What a type of node seems to be, where only its use in trees tells.
#ifndef COPPICE_EDITOR_DOCUMENT_SUGGESTED_MODEL_H_
#define COPPICE_EDITOR_DOCUMENT_SUGGESTED_MODEL_H_

#include <string_view>

#include "bt_core/model/node_model.h"
#include "editor/document/project_names.h"

namespace coppice::editor {

/// A node with children is a control node or a decorator, one whose name begins with Is or Has a
/// condition, any other an action; an explicit <Condition ID="..."/> is what it says. Attributes
/// are inputs; their types are those that all literals fit.
NodeModel SuggestModel(const ProjectFiles& files, std::string_view type);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DOCUMENT_SUGGESTED_MODEL_H_
