// Rows of the inspector: a label, and beside it a value to read or a field to type in. Only what
// can be typed in looks like a field.
#ifndef COPPICE_EDITOR_PANELS_WIDGETS_INSPECTOR_ROW_H_
#define COPPICE_EDITOR_PANELS_WIDGETS_INSPECTOR_ROW_H_

#include <string>
#include <string_view>

#include "editor/panels/widgets/field.h"
#include "editor/panels/widgets/panel.h"

namespace coppice::editor {

/// A value to read, registered as `path`.
Row ValueRow(const Ui& ui, const std::string& path, std::string_view label, std::string_view value,
             const TextStyle& style);

/// A field to type in; `path` and `key` as in DrawField. A `problem` is marked, and told when the
/// mouse is over the field.
FieldResult FieldRow(const Ui& ui, EditorState& state, const std::string& path,
                     const std::string& key, std::string_view label, const std::string& value,
                     const FieldLook& look, const std::string& problem);

/// A title over the rows below it.
void HeadingRow(const Ui& ui, std::string_view text);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_WIDGETS_INSPECTOR_ROW_H_
