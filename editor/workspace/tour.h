// The two-minute tour: steps that point at parts of the window. A step is done when the user
// has done what it says, or goes on without. Without ImGui; panels/tour draws it.
//
//   Tour tour;                       // of EditorState
//   StartTour(state);
//   UpdateTour(state);               // once per frame: goes on when the step was done
#ifndef COPPICE_EDITOR_WORKSPACE_TOUR_H_
#define COPPICE_EDITOR_WORKSPACE_TOUR_H_

#include <cstddef>
#include <string_view>
#include <vector>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

struct TourStep {
  std::string_view item;  ///< in the registry of items: what it points at
  std::string_view title;
  std::string_view text;
  /// Makes that part visible; null: it is.
  void (*prepare)(EditorState&);
  /// Whether the user has done it; null: it is only to be read.
  bool (*is_done)(EditorState&);
  /// What the text ends with, as the settings are; null: nothing.
  std::string_view (*end)(const EditorState&) = nullptr;
};

/// Its text as a whole.
std::string TextOf(const TourStep& step, const EditorState& state);

const std::vector<TourStep>& TourSteps();

/// The step that is shown, or null.
const TourStep* ShownStep(const EditorState& state);

/// From the first step on, with the example if no tree is shown.
void StartTour(EditorState& state);
/// By 1 or -1; behind the last step it ends.
void StepTour(EditorState& state, int by);
void EndTour(EditorState& state);

/// Goes on if the user has just done what the step says. What was so before does not count.
void UpdateTour(EditorState& state);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_TOUR_H_
