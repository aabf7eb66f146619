// The rows of a popup: a list that scrolls below what is asked, one of which is chosen with the
// arrow keys.
//
//   PopupRows rows(ui, state, choices.size());
//   for (const Choice& choice : choices) clicked = rows.Next(choice.title, ...) || clicked;
#ifndef COPPICE_EDITOR_PANELS_POPUP_POPUP_ROWS_H_
#define COPPICE_EDITOR_PANELS_POPUP_POPUP_ROWS_H_

#include <cstddef>
#include <string>

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

inline constexpr std::size_t kPopupRows = 12;  ///< so many are in sight at most

class PopupRows {
 public:
  /// Begins a list of so many rows in the current ImGui window. Moves state.popup.choice if an
  /// arrow key was pressed; with `has_choice` that row is highlighted and kept in sight.
  PopupRows(const Ui& ui, EditorState& state, std::size_t count, bool has_choice = true);
  ~PopupRows();
  PopupRows(const PopupRows&) = delete;
  PopupRows& operator=(const PopupRows&) = delete;

  /// Draws the next one as "popup/NUMBER". True if it was clicked.
  bool Next(const std::string& title, const std::string& note, const std::string& kind);

 private:
  const Ui& ui_;
  EditorState& state_;
  const bool has_choice_;
  bool choice_has_moved_ = false;
  int next_ = 0;
};

/// A title with a dim word in front and a dim note at the right end. The note has the room that the
/// title leaves; of two long ones both are cut.
void PaintPopupRow(const Ui& ui, const Box& box, const std::string& title, const std::string& note,
                   const std::string& kind);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_POPUP_POPUP_ROWS_H_
