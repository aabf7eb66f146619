#include <algorithm>

#include "editor/document/fixes.h"
#include "editor/panels/panels.h"
#include "editor/panels/widgets/panel.h"
#include "editor/theme/icons.h"
#include "editor/workspace/project_editor.h"

namespace coppice::editor {
namespace {

// The element that a place in a text lies in: the last that starts at or before it.
ElementIndex ElementAt(const Document& document, const SourceLocation& where) {
  ElementIndex found = kNoElement;
  for (ElementIndex i{0}; i < document.elements().size(); ++i) {
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
        workspace.view()->RevealReadable(state.screen.canvas_size);
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

// Jumps to the node, where that is not the edit's own business.
void RunCommand(EditorState& state, int file, const Diagnostic& problem, const Fix& fix,
                double now) {
  if (file >= 0) JumpTo(state, static_cast<std::size_t>(file), problem, now);
  state.after_frame = [&state, command = fix.command] { state.commands.Run(command); };
}

void RunFix(EditorState& state, const Diagnostic& problem, const Fix& fix, double now) {
  if (fix.makes_format_4) {
    const Outcome made = ProjectEditor(state, now).MakeFormat4(problem.where.file);
    if (!made) state.Notify(made.problem(), now, true);
    return;
  }
  const EditedFile& file = *state.workspace.project().Find(problem.where.file);
  const ElementIndex element = file.document->ElementAt(OffsetOf(*file.document, problem.where));
  TreeEditor(state, now)
      .RunOn("Fix: " + fix.title, file.path, {element}, [&](Draft& draft, const NodeRules&) {
        return draft.Apply(fix.edit) ? Outcome() : Problem{"not possible"};
      });
  if (fix.port.empty()) return;
  state.screen.tiles.inspector = true;
  state.inspector.type.clear();
  state.input.focus_field = "inspector/port/" + fix.port;
}

constexpr float kLeft = 28;       // of the message, at scale 1
constexpr float kPad = 8;         // right of it
constexpr float kPlaceLine = 19;  // height of the line of the place and the buttons

// What a problem's row says, and how wide it is.
struct Words {
  std::string message;
  std::string where;
  std::vector<Fix> fixes;
  float message_width = 0;
  float rest_width = 0;  // of the place and the buttons

  // They fit into one line.
  bool Fit(const Ui& ui, float width) const {
    return message_width + rest_width + 48 * ui.scale <= width;
  }
  // Of the message in lines of that width.
  float Height(const Ui& ui, float width) const {
    return ui.ParagraphHeight(message, {Face::kSans, 12, 0}, width - (kLeft + kPad) * ui.scale);
  }
};

float WidthOf(const Ui& ui, const Fix& fix) {
  return ui.Width(fix.title, {Face::kSans, 12, 0}) + 14 * ui.scale;
}

Words WordsOf(const Ui& ui, const Diagnostic& problem, std::vector<Fix> fixes, bool names_file) {
  Words words;
  words.message = problem.message;
  if (!problem.hint.empty()) words.message += " (" + problem.hint + ")";
  const std::string file = problem.where.file.substr(problem.where.file.rfind('/') + 1);
  const std::string place =
      std::to_string(problem.where.line) + ":" + std::to_string(problem.where.column);
  words.where = problem.where.line == 0 ? file : names_file ? file + ":" + place : place;
  words.fixes = std::move(fixes);
  words.message_width = ui.Width(words.message, {Face::kSans, 12, 0});
  words.rest_width = ui.Width(words.where, {Face::kSans, 11, 0});
  for (const Fix& fix : words.fixes) words.rest_width += WidthOf(ui, fix);
  return words;
}

// A button for each fix at the right end of the line; returns the one that was pressed, or -1.
int DrawFixes(const Ui& ui, const std::string& path, Box& line, const std::vector<Fix>& fixes) {
  int pressed = -1;
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    const float width = WidthOf(ui, fixes[i]);
    const Box box = {{line.max.x - width, line.min.y + ui.scale},
                     {line.max.x - 2 * ui.scale, line.max.y - ui.scale}};
    const std::string item = path + "/fix/" + std::to_string(i);
    if (ui.Button(item, box, fixes[i].title)) pressed = static_cast<int>(i);
    line.max.x = box.min.x - 2 * ui.scale;
  }
  return pressed;
}

// The message, broken into lines if it is long, and behind it or below it the place and the
// buttons.
Row DrawProblem(const Ui& ui, int number, const Diagnostic& problem, std::vector<Fix> fixes,
                bool names_file, int& pressed) {
  const std::string path = "problems/" + std::to_string(number);
  const Words words = WordsOf(ui, problem, std::move(fixes), names_file);
  const float width = ImGui::GetContentRegionAvail().x;
  const bool fits = words.Fit(ui, width);
  const float message = words.Height(ui, width);
  const Row row = NextRow(ui, path, false, fits ? kRowHeight : message / ui.scale + 4 + kPlaceLine);
  ImGui::SetItemAllowOverlap();
  if (row.hovered) Tooltip(ui, ToString(problem));
  if (!row.visible) return row;
  const ImVec2 behind = ImGui::GetCursorScreenPos();
  const float pad = kPad * ui.scale;
  const float line_height = (fits ? kRowHeight : kPlaceLine) * ui.scale;
  Box last = {{row.box.min.x, row.box.max.y - line_height}, row.box.max - Point{pad / 2, 0}};
  pressed = DrawFixes(ui, path, last, words.fixes);
  ImGui::SetCursorScreenPos(behind);

  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool error = problem.severity == Severity::kError;
  ui.RowText(list, row.box.min + Point{pad, 0}, kRowHeight * ui.scale,
             error ? icon::kExclamation : icon::kWarning,
             {Face::kSans, 12, error ? ui.palette.error : ui.palette.warning});
  const float left = row.box.min.x + kLeft * ui.scale;
  const TextStyle style{Face::kSans, 12, ui.palette.text};
  if (fits) {
    ui.RowText(list, {left, row.box.min.y}, line_height, words.message, style);
  } else {
    ui.Paragraph(list, {left, row.box.min.y + 4 * ui.scale}, words.message, style,
                 width - (kLeft + kPad) * ui.scale);
  }
  const float at = fits ? left + words.message_width + pad : left;
  ui.RowText(list, {at, last.min.y}, line_height, words.where,
             {Face::kSans, 11, ui.palette.text_dim}, last.max.x - at - pad);
  return row;
}

std::string CountText(std::size_t errors, std::size_t warnings) {
  if (errors + warnings == 0) return "none";
  std::string text = errors > 0 ? Count(errors, "error") : "";
  if (warnings > 0) text += (text.empty() ? "" : ", ") + Count(warnings, "warning");
  return text;
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
  const auto is_error = [](const Entry& entry) {
    return entry.problem.severity == Severity::kError;
  };
  const auto warnings = std::stable_partition(all.begin(), all.end(), is_error);
  const std::string note = CountText(static_cast<std::size_t>(warnings - all.begin()),
                                     static_cast<std::size_t>(all.end() - warnings));
  Panel(ui, "problems", box, "PROBLEMS", note, [&] {
    if (all.empty()) {
      Hint(ui, workspace.files().empty() ? "What the engine's checker says about the open files."
                                         : "No problems. Files are checked while you edit.");
    }
    const bool names_files = std::any_of(all.begin(), all.end(), [&](const Entry& entry) {
      return entry.problem.where.file != all.front().problem.where.file;
    });
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::vector<Fix> fixes = FixesOf(state, all[i].problem);
      int pressed = -1;
      const Row row =
          DrawProblem(ui, static_cast<int>(i), all[i].problem, fixes, names_files, pressed);
      if (pressed >= 0) {
        const Fix& fix = fixes[static_cast<std::size_t>(pressed)];
        fix.command.empty() ? RunFix(state, all[i].problem, fix, ui.now)
                            : RunCommand(state, all[i].file, all[i].problem, fix, ui.now);
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
