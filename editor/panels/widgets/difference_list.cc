#include "editor/panels/widgets/difference_list.h"

#include "editor/panels/widgets/panel.h"

namespace coppice::editor {

float DrawDifferenceButtons(const Ui& ui, EditorState& state, Point right_top, float height) {
  const float width = 74 * ui.scale;
  const float gap = 4 * ui.scale;
  float right = right_top.x;
  const auto button = [&](const char* path, const char* text, const char* command) {
    const Box box = {{right - width, right_top.y}, {right, right_top.y + height}};
    if (ui.Button(path, box, text)) {
      state.after_frame = [&s = state, command] { s.commands.Run(command); };
    }
    ExplainCommand(ui, state.commands, command);
    right = box.min.x - gap;
  };
  button("comparison/next", "next", "difference.next");
  button("comparison/previous", "previous", "difference.previous");
  return right;
}

void DrawDifferenceList(const Ui& ui, EditorState& state, Comparison& comparison, const Box& box) {
  const auto& differences = comparison.differences();
  Panel(ui, "comparison/list", box, "DIFFERENCES", Count(differences.size(), "difference"), [&] {
    for (std::size_t i = 0; i < differences.size(); ++i) {
      const bool is_selected = i == comparison.selected();
      const Row row =
          TextRow(ui, "comparison/difference/" + std::to_string(i), differences[i].sentence,
                  {is_selected ? Face::kBold : Face::kSans, 12, ui.palette.text});
      if (row.clicked) comparison.Select(i, state.screen.canvas_size);
    }
  });
}

}  // namespace coppice::editor
