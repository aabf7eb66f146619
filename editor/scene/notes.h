// Comments of a file as notes about nodes.
//
// A comment is about the element that follows it; behind an element on the same line it is about
// that one, and behind the last child about the last child. What stands before a <BehaviorTree> is
// about its root. What has neither letter nor digit is a line drawn between trees, no note.
#ifndef COPPICE_EDITOR_SCENE_NOTES_H_
#define COPPICE_EDITOR_SCENE_NOTES_H_

#include <string>

#include "bt_core/model/document.h"

namespace coppice::editor {

/// All comments about that element, as one line with single blanks, of a long one the beginning.
/// Looks only at what lies between the element and its neighbours.
std::string NoteOf(const Document& document, ElementIndex element);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SCENE_NOTES_H_
