// Widgets for the value of one attribute, made for its type. Each returns the new value in the
// frame in which the user has finished: with Enter, by a click elsewhere, or by a button.
#ifndef COPPICE_EDITOR_PANELS_WIDGETS_FIELD_H_
#define COPPICE_EDITOR_PANELS_WIDGETS_FIELD_H_

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/theme/ui.h"
#include "editor/workspace/editor_state.h"

namespace coppice::editor {

enum class FieldKind {
  kText,
  kBool,
  kNumber,
  kChoice,
  kPose  ///< "x;y;theta", with a field for each
};

struct FieldLook {
  FieldKind kind = FieldKind::kText;
  std::string_view hint;             ///< shown while the value is empty
  Color color = 0xFFFFFFFF;          ///< of the text
  std::vector<std::string> choices;  ///< of kChoice
  bool can_clear = false;            ///< with a button that takes the attribute away
  std::vector<std::string> keys;     ///< that Tab completes: behind '{', in a script any word
  bool is_script = false;
};

/// What the user did to the field.
struct FieldResult {
  std::optional<std::string> value;
  bool cleared = false;
};

/// `path` is for tests, `key` tells fields of different nodes apart. Registers `path`, and the
/// buttons as "PATH/toggle", "PATH/less", "PATH/more", "PATH/choices", "PATH/clear", the choices as
/// "PATH/choice/NAME", the parts of a pose as "PATH/x", "PATH/y", "PATH/theta", and for a value
/// that is none "PATH/pose".
FieldResult DrawField(const Ui& ui, EditorState& state, const std::string& path,
                      const std::string& key, const Box& box, const std::string& value,
                      const FieldLook& look);

/// The kind that suits values of a type of that name.
FieldKind KindOf(std::string_view type);

/// The keys that begin with the word that ends at the end of `text`; nothing where no key can
/// stand.
std::vector<std::string> Completions(std::string_view text, const FieldLook& look);

/// The values that a description says a port takes, as manifests do: "how fast: slow, fast or mad".
std::vector<std::string> ChoicesIn(std::string_view description);

/// One step up or down from a number, with as many decimals as it has; nothing if it is none.
std::optional<std::string> Stepped(const std::string& number, int by);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_WIDGETS_FIELD_H_
