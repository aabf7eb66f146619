#include <cstdio>
#include <string>
#include <unordered_map>
#include <vector>

#include "editor/commands/run_commands.h"
#include "editor/panels/run/run_bodies.h"
#include "editor/panels/widgets/panel.h"
#include "editor/simulation/chance_text.h"
#include "editor/theme/icons.h"
#include "editor/workspace/simulation_editor.h"

namespace coppice::editor {
namespace {

std::string Number(std::uint64_t number) { return std::to_string(number); }

std::string Summary(const Coverage& coverage, std::uint64_t wanted) {
  const auto of = [&](Status status) {
    return Number(coverage.results[static_cast<std::size_t>(status)]);
  };
  const std::string runs = coverage.runs < wanted
                               ? Number(coverage.runs) + " of " + Count(wanted, "run")
                               : Count(coverage.runs, "run");
  return runs + " from seed " + Number(coverage.first_seed) + ", " + Count(coverage.ticks, "tick") +
         ": " + of(Status::kSuccess) + " SUCCESS, " + of(Status::kFailure) + " FAILURE, " +
         of(Status::kRunning) + " cut short";
}

class Rows {
 public:
  Rows(const Ui& ui, EditorState& state, RunView& run) : ui_(ui), state_(state) {
    const auto& nodes = run.tree()->description()->nodes;
    for (NodeIndex i{0}; i < nodes.size(); ++i) number_.emplace(nodes[i].path, i);
    const TreeView* view = state.workspace.view();
    const NodeIndex selected = view ? view->selected_run_node() : kNoNode;
    if (selected < nodes.size()) selected_ = nodes[selected].path;
  }

  void Draw() {
    const CoverageJob& job = state_.coverage;
    if (!job.coverage()) {
      Run("Run the tree many times with leaves that act at random: what is reached?");
      return;
    }
    const Coverage& coverage = *job.coverage();
    Title("run/coverage/all", Summary(coverage, job.wanted()), ui_.palette.text);
    DrawOrigin(job.play());
    const Simulation* simulation = state_.simulator.get();
    if (simulation && simulation->program().get() != &job.program()) {
      Title("run/coverage/old", "The tree has been edited since.", ui_.palette.warning);
    }
    for (std::size_t i = 0; i < coverage.findings.size(); ++i) Finding(i, coverage.findings[i]);
    List("never_ticked", "never ticked", NeverTicked(coverage));
    List("never_failure", "ticked, but never FAILURE", NeverReturned(coverage, Status::kFailure));
    List("never_success", "ticked, but never SUCCESS", NeverReturned(coverage, Status::kSuccess));
    Run("Run it again");
  }

 private:
  // The same file may have been changed since.
  void DrawOrigin(const RandomPlay& play) {
    const std::string origin = OriginOf(play);
    if (origin.empty()) return;
    TextRow(ui_, "run/coverage/origin", "Random, as " + origin + " says",
            {Face::kSans, 12, ui_.palette.text_dim});
  }

  void Run(const char* words) {
    const std::string text = std::string(words) + "   Shift+X";
    const Row row = TextRow(ui_, "run/coverage/run", text, {Face::kSans, 12, ui_.palette.accent});
    if (!row.clicked) return;
    state_.after_frame = [&s = state_] { s.commands.Run("sim.runs"); };
  }

  void Title(const std::string& path, const std::string& text, Color color) {
    TextRow(ui_, path, text, {Face::kBold, 12, color});
  }

  void Finding(std::size_t number, const RandomFinding& finding) {
    const std::string what =
        (finding.node.empty() ? "the tree" : "\"" + finding.node + "\"") + ": " + finding.text;
    const std::string when = Count(finding.times, "time") + ", first in tick " +
                             Number(finding.tick) + " of seed " + Number(finding.seed);
    const Row row = TextRow(ui_, "run/coverage/finding/" + std::to_string(number),
                            std::string(icon::kWarning) + "  " + what + "; " + when,
                            {Face::kSans, 12, ui_.palette.error});
    if (row.hovered) Tooltip(ui_, "Click to go there");
    if (row.clicked) {
      state_.after_frame = [&s = state_, finding, now = ui_.now] {
        SimulationEditor(s, now).GoToFinding(finding);
      };
    }
  }

  void List(const std::string& id, const char* title, const std::vector<std::string>& paths) {
    const std::string path = "run/coverage/" + id;
    Title(path, std::string(title) + ": " + (paths.empty() ? "none" : Number(paths.size())),
          paths.empty() ? ui_.palette.text_dim : ui_.palette.text);
    for (const std::string& node : paths) Node(path + "/" + node, node);
  }

  void Node(const std::string& path, const std::string& node) {
    const auto number = number_.find(node);
    const Row row = NextRow(ui_, path, node == selected_);
    if (row.clicked && number != number_.end()) SelectRunNode(state_, number->second);
    if (!row.visible) return;
    const float x = Write(row, 22, node, {Face::kSans, 12, ui_.palette.text});
    const NodeCoverage& counts = *state_.coverage.Find(node);
    if (counts.ticks() == 0) return;
    std::string text = Count(counts.ticks(), "tick");
    for (const Status status : {Status::kSuccess, Status::kFailure, Status::kSkipped}) {
      if (counts.results_of(status) == 0) continue;
      text += ", " + Number(counts.results_of(status)) + " " + ToString(status);
    }
    Write(row, x + 10, text, {Face::kSans, 11, ui_.palette.text_dim});
  }

  // Returns where the text ends, at scale 1.
  float Write(const Row& row, float x, const std::string& text, const TextStyle& style) const {
    const float room = row.box.width() - (x + 8) * ui_.scale;
    if (room <= 0) return x;
    const float width =
        ui_.RowText(*ImGui::GetWindowDrawList(), row.box.min + Point{x * ui_.scale, 0},
                    row.box.height(), text, style, room);
    return x + width / ui_.scale;
  }

  const Ui& ui_;
  EditorState& state_;
  std::unordered_map<std::string, NodeIndex> number_;
  std::string selected_;
};

}  // namespace

void DrawCoverage(const Ui& ui, EditorState& state, RunView& run) { Rows(ui, state, run).Draw(); }

}  // namespace coppice::editor
