// Fonts that are baked once for all tests of a process: baking takes longer than most tests.
#ifndef COPPICE_TESTS_EDITOR_SHARED_FONTS_H_
#define COPPICE_TESTS_EDITOR_SHARED_FONTS_H_

#include <memory>

#include "editor/shell/editor.h"
#include "editor/theme/fonts.h"

namespace coppice::editor {

/// Those of that scale; they are there until the process ends.
std::shared_ptr<const Fonts> SharedFonts(float scale);

/// The options, with these fonts unless they have others.
EditorOptions WithSharedFonts(EditorOptions options);

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_SHARED_FONTS_H_
