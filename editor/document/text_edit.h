// A text with a caret: what the keys of a text editor do to it. Knows no window and no font.
//
//   TextEdit edit{text, 120, 120};
//   edit.Put("<Beep/>");
//   edit.Move(TextStep::kEnd, false);
//
// Offsets are bytes; steps are whole UTF-8 characters.
#ifndef COPPICE_EDITOR_DOCUMENT_TEXT_EDIT_H_
#define COPPICE_EDITOR_DOCUMENT_TEXT_EDIT_H_

#include <cstdint>
#include <string>
#include <string_view>

namespace coppice::editor {

enum class TextStep : std::uint8_t {
  kLeft,
  kRight,
  kWordLeft,
  kWordRight,
  kUp,
  kDown,
  kPageUp,
  kPageDown,
  kLineStart,  ///< the first character that is no blank, then the start of the line
  kEnd,
  kTextStart,
  kTextEnd
};

struct TextEdit {
  std::string text;
  std::size_t at = 0;      ///< of the caret
  std::size_t anchor = 0;  ///< the other end of what is selected

  std::size_t begin() const { return at < anchor ? at : anchor; }
  std::size_t end() const { return at < anchor ? anchor : at; }
  std::string_view selected() const {
    return std::string_view(text).substr(begin(), end() - begin());
  }

  /// In the place of what is selected.
  void Put(std::string_view what);
  /// A line end as the text has them, and the indentation of this line.
  void PutLineEnd();
  /// What is selected, else the character before or behind the caret.
  void Erase(bool forward);
  /// With `extend`, what is selected grows.
  void Move(TextStep step, bool extend);
  void SelectAll();
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DOCUMENT_TEXT_EDIT_H_
