#include "editor/core/tree_editor.h"
#include "editor/document/fixes.h"
#include "editor/look/icons.h"
#include "editor/panels/panel.h"
#include "editor/panels/panels.h"

namespace coppice::editor {
namespace {

// The element that a place in a text lies in: the last that starts at or before it.
ElementIndex ElementAt(const Document& document, const SourceLocation& where) {
  ElementIndex found = kNoElement;
  for (ElementIndex i = 0; i < document.elements().size(); ++i) {
    const SourceLocation at = document.Location(document.element(i).offset);
    if (at.line > where.line || (at.line == where.line && at.column > where.column)) break;
    found = i;
  }
  return found;
}

// Shows the tree that the problem is in, and selects its node.
void JumpTo(EditorState& state, std::size_t number, const Diagnostic& problem, double now) {
  Workspace& workspace = state.workspace;
  const auto forest = workspace.files()[number].forest;
  for (std::uint32_t d = 0; d < forest->documents().size(); ++d) {
    const Document& document = *forest->documents()[d];
    if (document.file() != problem.where.file) continue;
    const ElementIndex element = ElementAt(document, problem.where);
    for (std::size_t t = 0; t < forest->trees().size(); ++t) {
      const TreeEntry& tree = forest->trees()[t];
      const bool inside = tree.document == d && element != kNoElement && element >= tree.element &&
                          (document.element(tree.element).next_sibling == kNoElement ||
                           element < document.element(tree.element).next_sibling);
      if (!inside) continue;
      workspace.ShowFileTree(number, static_cast<int>(t), now);
      if (workspace.SelectElement(document, element)) {
        workspace.view()->Reveal(state.canvas_size);
      }
      return;
    }
  }
  workspace.ShowFileTree(number, forest->main_tree(), now);
}

// What would make it go away; of the text as it is now.
std::vector<Fix> FixesOf(const EditorState& state, const Diagnostic& problem) {
  const EditedFile* file = state.workspace.project().Find(problem.where.file);
  return file && file->document ? FixesFor(*file->document, problem) : std::vector<Fix>();
}

void RunFix(EditorState& state, const Diagnostic& problem, const Fix& fix, double now) {
  const EditedFile& file = *state.workspace.project().Find(problem.where.file);
  const ElementIndex element = file.document->ElementAt(OffsetOf(*file.document, problem.where));
  TreeEditor(state, now)
      .RunOn("Fix: " + fix.title, file.path, {element}, [&](Draft& draft, const NodeRules&) {
        return draft.Apply(fix.edit) ? "" : "not possible";
      });
}

// A button for each fix at the right end of the row; returns the one that was pressed, or -1.
int DrawFixes(const Ui& ui, const std::string& path, Box& rest, const std::vector<Fix>& fixes) {
  int pressed = -1;
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    const float width = ui.Width(fixes[i].title, {Face::kSans, 12, 0}) + 14 * ui.scale;
    const Box box = {{rest.max.x - width, rest.min.y + ui.scale},
                     {rest.max.x - 2 * ui.scale, rest.max.y - ui.scale}};
    const std::string item = path + "/fix/" + std::to_string(i);
    if (ui.Button(item, box, fixes[i].title)) pressed = static_cast<int>(i);
    rest.max.x = box.min.x - 2 * ui.scale;
  }
  return pressed;
}

Row DrawProblem(const Ui& ui, int number, const Diagnostic& problem, const std::vector<Fix>& fixes,
                int& pressed) {
  Row row = NextRow(ui, "problems/" + std::to_string(number), false);
  ImGui::SetItemAllowOverlap();
  const ImVec2 behind = ImGui::GetCursorScreenPos();
  if (row.visible) {
    pressed = DrawFixes(ui, "problems/" + std::to_string(number), row.box, fixes);
    ImGui::SetCursorScreenPos(behind);
  }

  const std::string text = ToString(problem);
  if (row.hovered) ImGui::SetTooltip("%s", text.c_str());
  if (!row.visible) return row;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool error = problem.severity == Severity::kError;
  const Color color = error ? ui.palette.error : ui.palette.warning;
  const float pad = 8 * ui.scale;
  ui.RowText(list, row.box.min + Point{pad, 0}, row.box.height(),
             error ? icon::kExclamation : icon::kWarning, {Face::kSans, 12, color});
  std::string where = problem.where.file.substr(problem.where.file.rfind('/') + 1);
  if (problem.where.line) {
    where += ":" + std::to_string(problem.where.line) + ":" + std::to_string(problem.where.column);
  }
  std::string message = problem.message;
  if (!problem.hint.empty()) message += " (" + problem.hint + ")";
  const Point at = row.box.min + Point{pad + 20 * ui.scale, 0};
  const float room = row.box.max.x - at.x - pad;
  const float used =
      ui.RowText(list, at, row.box.height(), where, {Face::kSans, 11, ui.palette.text_dim}, room);
  ui.RowText(list, at + Point{used + pad, 0}, row.box.height(), message,
             {Face::kSans, 12, ui.palette.text}, room - used - pad);
  return row;
}

}  // namespace

void DrawProblems(const Ui& ui, EditorState& state, const Box& box) {
  Workspace& workspace = state.workspace;
  struct Entry {
    Diagnostic problem;
    int file;  // -1: not of a file
  };
  std::vector<Entry> all;
  for (const Diagnostic& problem : workspace.model_problems()) all.push_back({problem, -1});
  for (std::size_t f = 0; f < workspace.files().size(); ++f) {
    for (const Diagnostic& problem : workspace.files()[f].problems) {
      all.push_back({problem, static_cast<int>(f)});
    }
  }
  for (const Diagnostic& problem : workspace.record_problems()) all.push_back({problem, -1});
  for (const auto& run : workspace.runs()) {
    const std::string& problem = run->connection().problem;
    if (!problem.empty()) {
      all.push_back({{Severity::kWarning, {run->name(), 0, 0}, problem, {}}, -1});
    }
  }
  const std::string note = all.empty() ? "none" : std::to_string(all.size());
  Panel(ui, "problems", box, "PROBLEMS", note, [&] {
    if (all.empty()) Hint(ui, "No problems.");
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::vector<Fix> fixes = FixesOf(state, all[i].problem);
      int pressed = -1;
      const Row row = DrawProblem(ui, static_cast<int>(i), all[i].problem, fixes, pressed);
      if (pressed >= 0) {
        RunFix(state, all[i].problem, fixes[static_cast<std::size_t>(pressed)], ui.now);
        return;
      }
      if (row.clicked && all[i].file >= 0) {
        JumpTo(state, static_cast<std::size_t>(all[i].file), all[i].problem, ui.now);
        return;
      }
    }
  });
}

}  // namespace coppice::editor
