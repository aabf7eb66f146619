#include <string>

#include "editor/panels/panels.h"
#include "editor/panels/widgets/panel.h"
#include "editor/theme/icons.h"
#include "editor/workspace/simulation_editor.h"

namespace coppice::editor {
namespace {

using State = ScenarioTest::State;

std::string NameOf(const std::string& path) { return path.substr(path.rfind('/') + 1); }

std::string PlaceOf(const SourceLocation& where) {
  return NameOf(where.file) + ":" + std::to_string(where.line) + ":" + std::to_string(where.column);
}

class Rows {
 public:
  Rows(const Ui& ui, EditorState& state) : ui_(ui), state_(state) {}

  void Draw() {
    if (state_.tests.all().empty()) {
      Hint(ui_,
           "Ctrl+Shift+R runs the *.test.json beside the open files. F5 simulates the tree; \"as "
           "test\" makes a test of what was done there.");
    }
    for (std::size_t i = 0; i < state_.tests.all().size(); ++i) {
      const ScenarioTest& test = state_.tests.all()[i];
      if (DrawTest(i, test)) {
        state_.after_frame = [&s = state_, test, now = ui_.now] {
          SimulationEditor(s, now).ShowTest(test);
        };
      }
      for (std::size_t k = 0; k < test.differences.size(); ++k) {
        DrawDifference("tests/" + std::to_string(i) + "/" + std::to_string(k), test.differences[k]);
      }
    }
  }

 private:
  bool DrawTest(std::size_t number, const ScenarioTest& test) {
    const Row row = NextRow(ui_, "tests/" + std::to_string(number), false);
    if (row.hovered && !test.problem.empty()) Tooltip(ui_, test.problem);
    if (!row.visible) return row.clicked;
    static const char* const kGlyphs[] = {icon::kCircleOpen, icon::kCheck, icon::kTimes,
                                          icon::kWarning};
    static const char* const kNote[] = {"not run", "passed", "FAILED", "cannot be played"};
    const Color colors[] = {ui_.palette.text_dim, ui_.palette.success_text, ui_.palette.error,
                            ui_.palette.error};
    const auto state = static_cast<std::size_t>(test.state);
    const float pad = 8 * ui_.scale;
    const TextStyle note{Face::kSans, 12, colors[state]};
    const float note_width = ui_.Width(kNote[state], note);
    Write(row, row.box.width() - note_width - pad, kNote[state], note, pad);
    const float right = note_width + 2 * pad;
    float x = Write(row, pad, kGlyphs[state], {Face::kSans, 12, colors[state]}, right);
    x = Write(row, x, test.name.empty() ? NameOf(test.file) : test.name,
              {Face::kSans, 12, ui_.palette.text}, right);
    Write(row, x, PlaceOf(test.where), {Face::kSans, 11, ui_.palette.text_dim}, right);
    return row.clicked;
  }

  void DrawDifference(const std::string& path, const coppice::Difference& difference) {
    const Row row = TextRow(ui_, path,
                            "step " + std::to_string(difference.step) + ", " + difference.what +
                                ": expected " + difference.expected + ", got " + difference.got,
                            {Face::kSans, 12, ui_.palette.error});
    if (row.hovered) Tooltip(ui_, PlaceOf(difference.where));
  }

  // As far as `right` from the right end of the row.
  float Write(const Row& row, float x, const std::string& text, const TextStyle& style,
              float right) {
    const float room = row.box.width() - x - right;
    if (room < 10 * ui_.scale) return x;
    const float width = ui_.RowText(*ImGui::GetWindowDrawList(), row.box.min + Point{x, 0},
                                    row.box.height(), text, style, room + 1);
    return x + width + 10 * ui_.scale;
  }

  const Ui& ui_;
  EditorState& state_;
};

}  // namespace

void DrawTests(const Ui& ui, EditorState& state, const Box& box) {
  const ScenarioTests& tests = state.tests;
  const std::size_t all = tests.all().size();
  const std::string note = all == 0 ? ""
                                    : std::to_string(tests.Count(State::kPassed)) + " of " +
                                          std::to_string(all) + " passed";
  Panel(ui, "tests", box, "TESTS", note, [&] { Rows(ui, state).Draw(); });
  const float width = ui.Width("run", {Face::kSans, 12, 0}) + 16 * ui.scale;
  const Point corner = {box.min.x + 64 * ui.scale, box.min.y + 2 * ui.scale};
  if (ui.Button("tests/run", {corner, corner + Point{width, (kPanelHeader - 4) * ui.scale}},
                "run")) {
    state.commands.Run("sim.tests");
  }
}

}  // namespace coppice::editor
